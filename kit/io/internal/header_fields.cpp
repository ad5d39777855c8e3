// SPDX-License-Identifier: Apache-2.0
// Fields of headers.
#include <solidsubdiv/kit/io/internal/header_fields.h>

namespace SolidSubdiv::Io::Internal {

std::string_view HeaderFields::Trimmed(std::string_view text) {
    while (!text.empty() && IsSpace(text.front())) text.remove_prefix(1);
    while (!text.empty() && IsSpace(text.back())) text.remove_suffix(1);
    return text;
}

std::string_view HeaderFields::Text(std::string_view name) const {
    const auto found = values_.find(std::string(name));
    return found == values_.end() ? std::string_view() : found->second;
}

std::string_view HeaderFields::Required(std::string_view name) const {
    if (!Has(name)) Fail(file_, "the header has no field " + Quoted(name));
    return Text(name);
}

std::vector<double> HeaderFields::Reals(std::string_view name, std::size_t n) const {
    TextCursor text = CursorAt(name);
    std::vector<double> numbers;
    while (text.SkipSpace()) numbers.push_back(text.Real("a number"));
    if (numbers.size() != n) {
        text.FailHere(std::to_string(n) + " numbers are needed, " + std::to_string(numbers.size()) + " are there");
    }
    return numbers;
}

std::int64_t HeaderFields::Integer(std::string_view name) const {
    TextCursor text = CursorAt(name);
    return text.Integer("a whole number");
}

std::vector<std::int64_t> HeaderFields::Integers(std::string_view name) const {
    TextCursor text = CursorAt(name);
    std::vector<std::int64_t> numbers;
    while (text.SkipSpace()) numbers.push_back(text.Integer("a whole number"));
    return numbers;
}

std::vector<std::string_view> HeaderFields::Words(std::string_view name) const {
    TextCursor text = CursorAt(name);
    std::vector<std::string_view> words;
    while (text.SkipSpace()) words.push_back(text.Word());
    return words;
}

void HeaderFields::FailAt(std::string_view name, const std::string& what) const {
    Fail(file_, "the field " + std::string(name) + ": " + what);
}

}  // namespace SolidSubdiv::Io::Internal
