// SPDX-License-Identifier: Apache-2.0
// What can go wrong, by whose fault. A bug is an assert; imperfect geometry is data (Far::Defect), not an exception.
#pragma once

#include <stdexcept>
#include <string>

namespace SolidSubdiv {

/// Base of every exception that the framework throws on purpose.
class Error : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

/// The caller's data can't be used; the text names the element and the value, and what to do.
class InvalidInput : public Error {
  public:
    using Error::Error;
};

/// A file can't be read or written; the text starts with the file's name.
class IoError : public Error {
  public:
    using Error::Error;
};

/// A solver did not reach its aim; the text is its report.
class SolverError : public Error {
  public:
    using Error::Error;
};

/// A progress callback asked to stop.
class Cancelled : public Error {
  public:
    Cancelled() : Error("cancelled") {}
};

}  // namespace SolidSubdiv
