#include "import/krl_values.hpp"

namespace wristwise {

namespace {

/// An axis or a coordinate: never a word.
bool is_number(const std::string& name) {
  if (name.size() == 1) return std::string("XYZABC").find(name) != std::string::npos;
  return name.size() == 2 && (name[0] == 'A' || name[0] == 'E') && name[1] >= '1' && name[1] <= '6';
}

void read_component(TokenReader& reader, KrlAggregate& aggregate) {
  const std::string name = reader.word("a component such as A1 or X");
  if (reader.accept_symbol('[')) {  // a name or comment: NAME[] "..."
    reader.expect_symbol(']');
    reader.next();
    return;
  }
  const bool is_word = reader.peek().kind == Token::Kind::word;
  if (!is_number(name) && (reader.accept_symbol('#') || is_word)) {
    reader.word("a value");
    return;
  }
  if (!is_number(name) &&
      reader.at_symbol('\'')) {  // a binary or hexadecimal number: 'B110', 'H1A'
    reader.next();
    reader.skip_past('\'');
    return;
  }
  const double value = reader.number("the value of " + name);
  if (!aggregate.emplace(name, value).second) reader.fail(name + " is given twice", "once");
}

}  // namespace

KrlAggregate read_aggregate(TokenReader& reader) {
  KrlAggregate aggregate;
  reader.expect_symbol('{');
  if (reader.peek().kind == Token::Kind::word && reader.peek(1).text == ":") {
    reader.next();  // the type
    reader.next();
  }
  do {
    read_component(reader, aggregate);
  } while (reader.accept_symbol(','));
  reader.expect_symbol('}');
  return aggregate;
}

}  // namespace wristwise
