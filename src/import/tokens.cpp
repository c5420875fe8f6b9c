#include "import/tokens.hpp"

#include <charconv>
#include <cmath>

#include "wristwise/error.hpp"

namespace wristwise {

namespace {

bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool starts_word(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_' || c == '$';
}
char capital(char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c; }
bool is_printable(char c) { return c > ' ' && c <= '~'; }

class Lexer {
 public:
  Lexer(const std::string& program, const TokenRules& rules, int line)
      : text_(program), rules_(rules), line_(line) {}

  std::vector<Token> run() {
    while (at_ < text_.size()) step();
    add(Token::Kind::line_end, "", rules_.line_ends);
    add(Token::Kind::end, "");
    return std::move(tokens_);
  }

 private:
  void step() {
    const char c = text_[at_];
    if (c == '\n') {
      add(Token::Kind::line_end, "", rules_.line_ends);
      ++line_;
      ++at_;
    } else if (c == rules_.comment) {
      while (at_ < text_.size() && text_[at_] != '\n') ++at_;
    } else if (starts_word(c)) {
      word();
    } else if (is_digit(c) || (c == '.' && at_ + 1 < text_.size() && is_digit(text_[at_ + 1]))) {
      number();
    } else if (c == '"') {
      quoted();
    } else {
      if (c != ' ' && c != '\t' && c != '\r') add(Token::Kind::symbol, std::string(1, c));
      ++at_;
    }
  }

  void word() {
    std::string word;
    while (at_ < text_.size() && (starts_word(text_[at_]) || is_digit(text_[at_])))
      word += capital(text_[at_++]);
    add(Token::Kind::word, word);
  }

  void number() {
    double value = 0;
    const char* start = text_.data() + at_;
    const auto parsed = std::from_chars(start, text_.data() + text_.size(), value);
    if (parsed.ec == std::errc::result_out_of_range) value = HUGE_VAL;
    const auto size = static_cast<std::size_t>(parsed.ptr - start);
    add(Token::Kind::number, text_.substr(at_, size));
    tokens_.back().value = value;
    at_ += size;
  }

  void quoted() {
    const std::size_t end = text_.find_first_of("\"\n", at_ + 1);
    const std::size_t stop = end == std::string::npos ? text_.size() : end;
    add(Token::Kind::text, text_.substr(at_ + 1, stop - at_ - 1));
    at_ = stop < text_.size() && text_[stop] == '"' ? stop + 1 : stop;
  }

  void add(Token::Kind kind, std::string text, bool wanted = true) {
    if (wanted) tokens_.push_back({kind, std::move(text), 0, line_});
  }

  const std::string& text_;
  TokenRules rules_;
  int line_;
  std::size_t at_ = 0;
  std::vector<Token> tokens_;
};

std::string shown(const Token& token) {
  if (token.kind == Token::Kind::end) return "the end of the file";
  if (token.kind == Token::Kind::line_end) return "the end of the line";
  std::string text = token.text.substr(0, 40);
  for (char& c : text)
    if (!is_printable(c) && c != ' ') c = '?';
  return "'" + text + "'";
}

}  // namespace

std::vector<Token> tokens_of(const std::string& program, const TokenRules& rules, int first_line) {
  return Lexer(program, rules, first_line).run();
}

const Token& TokenReader::peek(std::size_t ahead) const {
  return tokens_[std::min(at_ + ahead, tokens_.size() - 1)];
}

Token TokenReader::next() {
  Token token = peek();
  if (at_ + 1 < tokens_.size()) ++at_;
  return token;
}

bool TokenReader::at_word(const std::string& word) const {
  return peek().kind == Token::Kind::word && peek().text == word;
}

bool TokenReader::at_symbol(char symbol) const {
  return peek().kind == Token::Kind::symbol && peek().text[0] == symbol;
}

bool TokenReader::accept_word(const std::string& word) {
  if (!at_word(word)) return false;
  next();
  return true;
}

bool TokenReader::accept_symbol(char symbol) {
  if (!at_symbol(symbol)) return false;
  next();
  return true;
}

void TokenReader::expect_symbol(char symbol) {
  if (!accept_symbol(symbol)) fail(shown(peek()), std::string("'") + symbol + "'");
}

std::string TokenReader::word(const std::string& what) {
  if (peek().kind != Token::Kind::word) fail(shown(peek()), what);
  return next().text;
}

double TokenReader::number(const std::string& what) {
  const bool negative = accept_symbol('-');
  if (!negative) accept_symbol('+');
  if (peek().kind != Token::Kind::number || !std::isfinite(peek().value))
    fail(shown(peek()), "a finite number, " + what);
  const double value = next().value;
  return negative ? -value : value;
}

void TokenReader::skip_line() {
  while (!at_line_end()) next();
  next();
}

void TokenReader::skip_past(char symbol) {
  while (!at_end() && !at_symbol(symbol)) next();
  next();
}

std::string TokenReader::where() const { return file_ + ":" + std::to_string(peek().line); }

void TokenReader::fail(const std::string& problem, const std::string& expected) const {
  throw InvalidInput(where(), problem, expected);
}

void TokenReader::not_understood(const std::string& expected) const {
  fail(shown(peek()) + " is not understood", expected);
}

}  // namespace wristwise
