// SPDX-License-Identifier: Apache-2.0
// Words, numbers and lines of a text.
#include <solidsubdiv/kit/io/internal/text.h>

#include <charconv>
#include <limits>

#include <solidsubdiv/sdc/errors.h>

namespace SolidSubdiv::Io::Internal {

void Fail(std::string_view file, const std::string& what) {
    std::string line = std::string(file) + ": " + what;
    for (char& c : line) {
        if (static_cast<unsigned char>(c) < ' ' || c == 127) c = '?';
    }
    throw IoError(line);
}

std::string Quoted(std::string_view word) {
    constexpr std::size_t longest = 40;
    std::string text(word.substr(0, longest));
    for (char& c : text) {
        if (c < ' ' || c > '~') c = '?';
    }
    return "'" + text + (word.size() > longest ? "...'" : "'");
}

std::string Counted(std::int64_t n, std::string_view singular, std::string_view plural) {
    return std::to_string(n) + " " + std::string(n == 1 ? singular : plural);
}

std::string LowerCase(std::string_view text) {
    std::string lower(text);
    for (char& c : lower) {
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    }
    return lower;
}

bool TextCursor::SkipSpace() {
    for (; at_ != end_; ++at_) {
        // Inside a line, a backslash before its end stands for a space (TextCursor::NextLine joined the lines).
        const bool joint = *at_ == '\\' && end_ - at_ > 1 && (at_[1] == '\n' || at_[1] == '\r');
        if (!IsSpace(*at_) && !joint) return true;
    }
    return false;
}

bool TextCursor::SkipComments(char mark) {
    while (SkipSpace()) {
        if (*at_ != mark) return true;
        RestOfLine();
    }
    return false;
}

std::string_view TextCursor::Word() {
    const std::string_view word = PeekWord();
    at_ += word.size();
    return word;
}

std::string_view TextCursor::PeekWord() {
    SkipSpace();
    const char* word_end = at_;
    while (word_end != end_ && !IsSpace(*word_end)) ++word_end;
    return {at_, static_cast<std::size_t>(word_end - at_)};
}

bool TextCursor::AtComment(char mark) { return !SkipSpace() || *at_ == mark; }

double TextCursor::Real(std::string_view what) {
    SkipSpace();
    const char* first = at_ + (at_ != end_ && *at_ == '+');
    double value = 0;
    const auto [last, error] = std::from_chars(first, end_, value);
    if (error == std::errc::invalid_argument || (last != end_ && !IsSpace(*last))) FailExpected(what);
    if (error == std::errc::result_out_of_range) {
        // Too small is zero; too large becomes infinite, which is refused where finite numbers are needed.
        const std::string_view digits(first, static_cast<std::size_t>(last - first));
        const bool small = digits.find("e-") != digits.npos || digits.find("E-") != digits.npos;
        value = small ? 0 : std::numeric_limits<double>::infinity();
    }
    at_ = last;
    return value;
}

std::int64_t TextCursor::Integer(std::string_view what) {
    SkipSpace();
    const char* first = at_ + (at_ != end_ && *at_ == '+');
    std::int64_t value = 0;
    const auto [last, error] = std::from_chars(first, end_, value);
    if (error != std::errc() || (last != end_ && !IsSpace(*last))) FailExpected(what);
    at_ = last;
    return value;
}

std::int64_t TextCursor::Count(std::string_view what, std::int64_t min_bytes) {
    const std::int64_t n = Integer("the number of " + std::string(what));
    // The last item may lack its separator.
    if (n < 0 || n > (remaining() + 1) / min_bytes) {
        FailHere(std::to_string(n) + " " + std::string(what) + " are announced, but only " +
                 Counted(remaining(), "byte", "bytes") + " follow; is the file complete?");
    }
    return n;
}

std::string_view TextCursor::RestOfLine() {
    const char* first = at_;
    while (at_ != end_ && *at_ != '\n' && *at_ != '\r') ++at_;
    const std::string_view line(first, static_cast<std::size_t>(at_ - first));
    if (at_ != end_) at_ += (*at_ == '\r' && end_ - at_ > 1 && at_[1] == '\n') ? 2 : 1;
    return line;
}

void TextCursor::SkipPastNewline() {
    while (at_ != end_ && *at_ != '\n') ++at_;
    if (at_ != end_) ++at_;
}

bool TextCursor::SkipPast(std::string_view text) {
    const std::string_view rest(at_, static_cast<std::size_t>(remaining()));
    const std::size_t found = rest.find(text);
    if (found != rest.npos) at_ += found + text.size();
    return found != rest.npos;
}

std::string_view TextCursor::Bytes(std::int64_t n, std::string_view what) {
    if (n < 0 || n > remaining()) {
        FailHere(std::string(what) + " should take " + std::to_string(n) + " bytes, but only " +
                 Counted(remaining(), "byte", "bytes") + " follow; is the file complete?");
    }
    const std::string_view bytes(at_, static_cast<std::size_t>(n));
    at_ += n;
    return bytes;
}

bool TextCursor::NextLine(TextCursor& line, bool joined) {
    if (at_ == end_) return false;
    const char* first = at_;
    std::string_view part = RestOfLine();
    while (joined && !part.empty() && part.back() == '\\' && at_ != end_) part = RestOfLine();
    line.begin_ = begin_;
    line.at_ = first;
    line.end_ = part.data() + part.size();
    return true;
}

void TextCursor::FailHere(const std::string& what) const {
    if (!place_.empty()) Fail(file_, place_ + ": " + what);
    std::int64_t line = 1;
    for (const char* c = begin_; c != at_; ++c) {
        line += *c == '\n' || (*c == '\r' && (c + 1 == end_ || c[1] != '\n'));
    }
    Fail(file_, "line " + std::to_string(line) + ": " + what);
}

void TextCursor::FailExpected(std::string_view what) const {
    TextCursor here = *this;
    const std::string_view word = here.PeekWord();
    const std::string found = word.empty() ? "the end" : Quoted(word);
    here.FailHere("expected " + std::string(what) + ", found " + found + (word.empty() ? "; is it complete?" : ""));
}

}  // namespace SolidSubdiv::Io::Internal
