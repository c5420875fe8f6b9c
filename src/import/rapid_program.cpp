// RAPID as far as MoveAbsJ, MoveJ and MoveL go, and ArcL, whose speed is in its weld data.

#include <algorithm>

#include "import/rapid_values.hpp"
#include "io/text_file.hpp"

namespace wristwise {

namespace {

using Words = std::vector<std::string>;

const Words kModifiers = {"LOCAL", "TASK"}, kStorage = {"CONST", "PERS", "VAR"};
const Words kLinearMoves = {"MOVEL", "ARCLSTART", "ARCL", "ARCLEND"};
/// Instructions that neither move nor say how the next move is made.
const Words kLeftOut = {"SETDO",    "SETAO",     "SETGO",     "SET",        "RESET",    "WAITTIME",
                        "WAITDI",   "WAITUNTIL", "CONFL",     "CONFJ",      "ACCSET",   "SINGAREA",
                        "TPWRITE",  "TPERASE",   "PULSEDO",   "CORRCLEAR",  "CLKSTART", "CLKSTOP",
                        "CLKRESET", "GRIPLOAD",  "MOTIONSUP", "PATHACCLIM", "STOP",     "WAITROB"};

bool is_one_of(const Token& token, const Words& words) {
  return token.kind == Token::Kind::word &&
         std::find(words.begin(), words.end(), token.text) != words.end();
}

class RapidReader {
 public:
  ProgramMoves read(const std::filesystem::path& file) {
    const std::vector<Token> tokens = tokens_of(read_text(file), {'!', false});
    TokenReader reader(tokens, file.string());
    while (!reader.at_end()) read_statement(reader);
    return std::move(moves_);
  }

 private:
  void read_statement(TokenReader& reader) {
    const Token first = reader.peek();
    while (is_one_of(reader.peek(), kModifiers)) reader.next();
    if (is_one_of(reader.peek(), kStorage)) {
      reader.next();
      values_.read_data(reader);
    } else if (reader.accept_symbol('%')) {  // the header of a saved module
      reader.skip_past('%');
    } else if (reader.accept_word("MODULE")) {
      reader.word("the name of the module");
      if (reader.at_symbol('(')) reader.skip_past(')');
    } else if (reader.accept_word("PROC")) {
      read_procedure(reader);
    } else if (reader.accept_word("ENDPROC") || reader.accept_word("ENDMODULE")) {
      return;
    } else if (reader.at_word("MOVEABSJ") || reader.at_word("MOVEJ") ||
               is_one_of(first, kLinearMoves)) {
      read_move(reader);
    } else if (reader.accept_word("VELSET")) {
      read_override(reader);
    } else if (is_one_of(first, kLeftOut)) {
      reader.skip_past(';');
    } else if (values_.has(first.text)) {
      values_.assign(reader);
    } else {
      reader.not_understood("MoveAbsJ, MoveJ, MoveL, targets and speeds");
    }
  }

  void read_procedure(TokenReader& reader) {
    if (!moves_.empty()) reader.fail("a second procedure in the file", "moves in one procedure");
    reader.word("the name of the procedure");
    reader.expect_symbol('(');
    reader.expect_symbol(')');
  }

  /// VelSet 50,1000: percent of programmed speeds.
  void read_override(TokenReader& reader) {
    const double percent = reader.number("a percentage");
    if (!(percent > 0 && percent <= 100)) reader.fail("a speed out of range", "0 to 100 percent");
    override_ = percent / 100;
    reader.expect_symbol(',');
    reader.number("mm/s");
    reader.expect_symbol(';');
  }

  void read_move(TokenReader& reader) {
    ProgramMove move;
    move.where = reader.where();
    const std::string instruction = reader.next().text;
    move.linear =
        std::find(kLinearMoves.begin(), kLinearMoves.end(), instruction) != kLinearMoves.end();
    if (reader.accept_symbol('\\')) {
      if (!reader.accept_word("CONC")) reader.not_understood("\\Conc");
      reader.expect_symbol(',');
    }
    if (instruction == "MOVEABSJ")
      values_.read_joint_target(reader, move);
    else
      values_.read_pose_target(reader, move);
    skip_switches(reader, {"ID", "NOEOFFS"});
    reader.expect_symbol(',');
    values_.read_speed(reader, move);
    if (move.linear && instruction != "MOVEL") {
      move.speed.reset();
      move.percent.reset();
    }
    if (move.speed) *move.speed *= override_;
    if (move.percent) *move.percent = all_percent(100 * override_);
    read_tool(reader, move.pose.has_value());
    moves_.push_back(std::move(move));
  }

  static void skip_switches(TokenReader& reader, const Words& known) {
    while (reader.accept_symbol('\\')) {
      if (!is_one_of(reader.peek(), known)) reader.not_understood("a switch");
      reader.next();
      if (!reader.accept_symbol(':')) continue;
      reader.expect_symbol('=');
      if (reader.at_symbol('-') || reader.peek().kind == Token::Kind::number)
        reader.number("of the switch");
      else
        reader.word("its value");
    }
  }

  /// Zone, seam and weld data, tool and work object, which stay the same for all poses.
  void read_tool(TokenReader& reader, bool to_pose) {
    std::string tool, work_object = "WOBJ0";
    while (reader.accept_symbol(',')) {
      tool = reader.word("zone, tool");
      while (reader.accept_symbol('\\')) {
        const std::string name = reader.word("a switch");
        if (!reader.accept_symbol(':')) continue;
        reader.expect_symbol('=');
        if (name == "WOBJ")
          work_object = reader.word("a work object");
        else if (reader.peek().kind == Token::Kind::number)
          reader.next();
        else
          reader.word("a value");
      }
    }
    reader.expect_symbol(';');
    if (!to_pose) return;
    if (!tool_.empty() && (tool != tool_ || work_object != work_object_))
      reader.fail("another tool or work object than at the poses before", "one of each");
    tool_ = tool;
    work_object_ = work_object;
  }

  RapidValues values_;
  ProgramMoves moves_;
  double override_ = 1;
  std::string tool_, work_object_;
};

}  // namespace

ProgramMoves read_rapid(const std::filesystem::path& file) { return RapidReader().read(file); }

}  // namespace wristwise
