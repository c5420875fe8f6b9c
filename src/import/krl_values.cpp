#include "import/krl_values.hpp"

namespace wristwise {

namespace {

void read_component(TokenReader& reader, KrlAggregate& aggregate) {
  const std::string name = reader.word("a component such as A1 or X");
  if (reader.accept_symbol('[')) {  // a name or comment: NAME[] "..."
    reader.expect_symbol(']');
    reader.next();
    return;
  }
  if (reader.accept_symbol('#') || reader.peek().kind == Token::Kind::word) {
    reader.word("a value");
    return;
  }
  if (reader.at_symbol('\'')) {  // a binary or hexadecimal number: 'B110', 'H1A'
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
