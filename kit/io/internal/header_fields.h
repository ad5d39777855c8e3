// SPDX-License-Identifier: Apache-2.0
// Headers of lines "name: value", "name = value" or "name value", as NRRD, MetaImage and PCD files have them.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include <solidsubdiv/kit/io/internal/text.h>

namespace SolidSubdiv::Io::Internal {

/// Fields by name, in lower case; the last one of a name counts. Messages name the field. The text must outlive it.
class HeaderFields {
  public:
    explicit HeaderFields(std::string file) : file_(std::move(file)) {}

    void Set(std::string_view name, std::string_view value) { values_[LowerCase(name)] = Trimmed(value); }

    bool Has(std::string_view name) const { return values_.count(std::string(name)) != 0; }
    /// The value as it stands, without blanks around it; empty if there is no such field.
    std::string_view Text(std::string_view name) const;
    /// The same, and the field must be there. @throws IoError
    std::string_view Required(std::string_view name) const;
    /// All numbers of a field, which must be n. @throws IoError
    std::vector<double> Reals(std::string_view name, std::size_t n) const;
    std::int64_t Integer(std::string_view name) const;
    /// All whole numbers of a field, as many as there are. @throws IoError
    std::vector<std::int64_t> Integers(std::string_view name) const;
    std::vector<std::string_view> Words(std::string_view name) const;

    [[noreturn]] void FailAt(std::string_view name, const std::string& what) const;

  private:
    static std::string_view Trimmed(std::string_view text);
    TextCursor CursorAt(std::string_view name) const {
        return {Required(name), file_, "the field " + std::string(name)};
    }

    std::string file_;
    std::map<std::string, std::string_view> values_;
};

}  // namespace SolidSubdiv::Io::Internal
