// SPDX-License-Identifier: Apache-2.0
// A pipe from /usr/bin/python3.
#include "python_script.h"

#include <sys/wait.h>

#include <array>
#include <cstdio>
#include <stdexcept>

#include "findings.h"

namespace SolidSubdiv::Validation {

namespace {

std::string ShellQuoted(const std::string& text) {
    std::string quoted = "'";
    for (const char c : text) quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return quoted + "'";
}

}  // namespace

std::string RunVtkScript(const std::filesystem::path& script, const std::vector<std::filesystem::path>& arguments) {
    constexpr int kNoModule = 3;
    if (!std::filesystem::exists(script)) throw std::runtime_error(script.string() + ": there is no such file");
    std::string command = "/usr/bin/python3 " + ShellQuoted(script.string());
    for (const auto& argument : arguments) command += " " + ShellQuoted(argument.string());
    std::FILE* pipe = ::popen((command + " 2>&1").c_str(), "r");
    if (!pipe) throw std::runtime_error("no shell to run /usr/bin/python3 in");
    std::string output;
    std::array<char, 4096> buffer;
    for (std::size_t n; (n = std::fread(buffer.data(), 1, buffer.size(), pipe)) > 0;) output.append(buffer.data(), n);
    const int status = ::pclose(pipe);
    const int code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    if (code == kNoModule || code == 127) {
        throw Unavailable{"VTK's Python module is not there for /usr/bin/python3 (Debian: python3-vtk9)"};
    }
    if (code != 0) throw std::runtime_error(script.filename().string() + ": " + output);
    return output;
}

}  // namespace SolidSubdiv::Validation
