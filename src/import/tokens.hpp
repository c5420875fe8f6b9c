#pragma once

#include <string>
#include <vector>

namespace wristwise {

/// A piece of a robot program.
struct Token {
  enum class Kind { word, number, text, symbol, line_end, end };
  Kind kind = Kind::end;
  std::string text;  ///< words in capitals; what stands between quotes; one character
  double value = 0;  ///< of a number, without sign
  int line = 0;      ///< from 1
};

/// What differs between languages.
struct TokenRules {
  char comment = ';';      ///< from here to the end of the line
  bool line_ends = false;  ///< they are tokens
};

/// Words (letters, digits, _ and $), numbers, quoted text and symbols. Never fails.
std::vector<Token> tokens_of(const std::string& program, const TokenRules& rules,
                             int first_line = 1);

/// Walks over tokens; what is not as expected is said with file and line.
class TokenReader {
 public:
  /// @param tokens must outlive the reader
  TokenReader(const std::vector<Token>& tokens, std::string file)
      : tokens_(tokens), file_(std::move(file)) {}

  const Token& peek(std::size_t ahead = 0) const;
  Token next();
  bool at_end() const { return peek().kind == Token::Kind::end; }
  bool at_line_end() const { return at_end() || peek().kind == Token::Kind::line_end; }
  bool at_word(const std::string& word) const;
  bool at_symbol(char symbol) const;
  bool accept_word(const std::string& word);
  bool accept_symbol(char symbol);
  void expect_symbol(char symbol);
  std::string word(const std::string& what);
  double number(const std::string& what);  ///< with an optional sign; finite
  void skip_line();                        ///< up to and with the end of the line
  void skip_past(char symbol);             ///< up to and with the next such symbol

  std::string where() const;  ///< "file:line" of the next token
  [[noreturn]] void fail(const std::string& problem, const std::string& expected = {}) const;
  /// "'IF' is not understood"
  [[noreturn]] void not_understood(const std::string& expected) const;

 private:
  const std::vector<Token>& tokens_;
  std::string file_;
  std::size_t at_ = 0;
};

}  // namespace wristwise
