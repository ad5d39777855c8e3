// SPDX-License-Identifier: Apache-2.0
// Reading of text: blank-separated words, numbers and lines, with the place of whatever is wrong.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace SolidSubdiv::Io::Internal {

/// Throws IoError "FILE: what", on one line whatever stands in the two.
[[noreturn]] void Fail(std::string_view file, const std::string& what);

/// A word of a file for a message: in quotes, shortened, unprintable bytes replaced.
std::string Quoted(std::string_view word);

/// "1 triangle", "2 triangles".
std::string Counted(std::int64_t n, std::string_view singular, std::string_view plural);

inline bool IsSpace(char c) { return c == ' ' || (c >= '\t' && c <= '\r'); }

/// ASCII only, whatever the locale.
std::string LowerCase(std::string_view text);

/// Walks over a text that it does not own. Lines end with \n, \r\n or \r.
class TextCursor {
  public:
    /// Messages name the line, or `place` if it isn't empty (text that is a part of something else).
    TextCursor(std::string_view text, std::string file, std::string place = {})
        : begin_(text.data()),
          at_(text.data()),
          end_(text.data() + text.size()),
          file_(std::move(file)),
          place_(std::move(place)) {}

    /// Moves to the next word; false if there is none.
    bool SkipSpace();
    /// Moves to the next word that is in no comment; comments go from `mark` to the end of the line.
    bool SkipComments(char mark);
    /// The next word, empty at the end.
    std::string_view Word();
    std::string_view PeekWord();
    /// Whether nothing follows, or a word that starts with the mark of a comment.
    bool AtComment(char mark = '#');
    double Real(std::string_view what);
    std::int64_t Integer(std::string_view what);
    /// A number of things to come, each of which takes at least min_bytes of the file: a count that the file's size
    /// can't hold is refused before anything is allocated for it.
    std::int64_t Count(std::string_view what, std::int64_t min_bytes = 2);

    /// What is left of the line, without its end; moves behind it.
    std::string_view RestOfLine();
    /// Moves behind the next \n: where binary data follow a line of text.
    void SkipPastNewline();
    /// Moves behind the next place where `text` stands; false (and no move) if there is none.
    bool SkipPast(std::string_view text);
    /// The next n bytes as they are.
    std::string_view Bytes(std::int64_t n, std::string_view what);

    /// The next line as a cursor of its own, whose messages name the right line. If joined, a backslash at the end of a
    /// line continues it on the next one.
    bool NextLine(TextCursor& line, bool joined = false);

    std::int64_t remaining() const { return end_ - at_; }
    const std::string& file() const { return file_; }
    [[noreturn]] void FailHere(const std::string& what) const;
    /// Says what was expected and what is there instead.
    [[noreturn]] void FailExpected(std::string_view what) const;

  private:
    const char* begin_;
    const char* at_;
    const char* end_;
    std::string file_;
    std::string place_;
};

}  // namespace SolidSubdiv::Io::Internal
