// Fanuc LS as far as J and L moves to positions P[...] go.

#include <algorithm>
#include <cmath>
#include <sstream>

#include "import/ls_positions.hpp"
#include "io/text_file.hpp"
#include "wristwise/error.hpp"

namespace wristwise {

namespace {

using Words = std::vector<std::string>;

/// Statements that neither move nor say how the next move is made: their first word.
const Words kLeftOut = {"ARC",  "WEAVE",   "DO",    "RO",      "GO",    "AO",        "WO",  "SO",
                        "WAIT", "PAYLOAD", "TIMER", "MESSAGE", "LBL",   "TRACK",     "END", "R",
                        "SR",   "F",       "M",     "COL",     "TOUCH", "TC_ONLINE", "RSR", "UALM"};
/// Words of a motion statement that put it elsewhere than at its position.
const Words kDisplaced = {"OFFSET", "TOOL_OFFSET", "INC", "SKIP", "VOFFSET", "RTCP"};

bool is_one_of(const std::string& word, const Words& words) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

struct Line {
  int number;
  std::string text;
};

struct Sections {
  std::vector<Line> instructions;
  std::string positions;
  int first_position_line = 1;
};

/// A move before its position is known.
struct Target {
  ProgramMove move;
  int position = 0;
};

Sections split(const std::filesystem::path& file) {
  Sections sections;
  std::istringstream text(read_text(file));
  std::string line, section;
  for (int number = 1; std::getline(text, line); ++number) {
    const std::size_t start = line.find_first_not_of(" \t\r");
    if (start != std::string::npos && line[start] == '/') {
      section = line.substr(start, line.find_first_of(" \t\r", start) - start);
      if (section == "/POS") sections.first_position_line = number + 1;
      if (section == "/END") break;
    } else if (section == "/MN") {
      sections.instructions.push_back({number, line});
    } else if (section == "/POS") {
      sections.positions += line + "\n";
    }
  }
  if (sections.instructions.empty())
    throw InvalidInput(file.string(), "no instructions", "a section /MN");
  return sections;
}

class LsReader {
 public:
  LsReader(std::filesystem::path file, int j3_coupling)
      : file_(std::move(file)), j3_coupling_(j3_coupling) {}

  ProgramMoves read() {
    const Sections sections = split(file_);
    read_instructions(sections.instructions);
    const std::vector<Token> tokens =
        tokens_of(sections.positions, {'\0', false}, sections.first_position_line);
    TokenReader reader(tokens, file_.string());
    const LsPositions positions = read_ls_positions(reader, j3_coupling_);
    ProgramMoves moves;
    for (Target& target : targets_) moves.push_back(placed(target, positions));
    return moves;
  }

 private:
  /// A statement runs to its semicolon, over several lines where need be.
  void read_instructions(const std::vector<Line>& lines) {
    std::string statement;
    int first = 0;
    for (const Line& line : lines) {
      const std::size_t colon = line.text.find(':');
      const bool numbered =
          colon != std::string::npos && line.text.find_first_not_of(" \t0123456789") == colon;
      if (statement.empty()) first = line.number;
      statement += numbered ? line.text.substr(colon + 1) : line.text;
      const std::size_t end = statement.find_last_not_of(" \t\r");
      if (end == std::string::npos) {
        statement.clear();
      } else if (statement[end] == ';') {
        read_statement(statement, first);
        statement.clear();
      } else {
        statement += ' ';
      }
    }
    if (!statement.empty())
      throw InvalidInput(file_.string() + ":" + std::to_string(first),
                         "an instruction without an end", "';'");
  }

  void read_statement(const std::string& statement, int line) {
    const std::size_t start = statement.find_first_not_of(" \t");
    if (statement[start] == '!' || statement[start] == '/' ||
        statement.compare(start, 2, "--") == 0)
      return;
    const std::vector<Token> tokens = tokens_of(statement, {'\0', false}, line);
    TokenReader reader(tokens, file_.string());
    const std::string first = reader.peek().text;
    if (reader.at_symbol(';') || is_one_of(first, kLeftOut)) return;
    if (first == "UFRAME_NUM" || first == "UTOOL_NUM") return;  // positions say theirs
    if (first == "J" || first == "L") {
      read_move(reader);
      return;
    }
    reader.not_understood("J P[...] and L P[...]");
  }

  void read_move(TokenReader& reader) {
    Target target;
    target.move.where = reader.where();
    target.move.linear = reader.next().text == "L";
    reader.accept_symbol('@');
    if (!reader.accept_word("P")) reader.not_understood("P[...]");
    reader.expect_symbol('[');
    const double number = reader.number("the number of a position");
    if (number != std::floor(number) || number < 0 || number > 1e6)
      reader.fail("no number of a position", "a whole number");
    target.position = static_cast<int>(number);
    if (reader.accept_symbol(':')) reader.next();
    reader.expect_symbol(']');
    read_speed(reader, target.move);
    for (; !reader.at_end(); reader.next())
      if (reader.peek().kind == Token::Kind::word && is_one_of(reader.peek().text, kDisplaced))
        reader.not_understood("moves to the position itself");
    targets_.push_back(std::move(target));
  }

  /// 50%, 1.5sec, 500msec, 10mm/sec, 60cm/min, 20inch/min; a speed that is a word is not known
  /// here.
  static void read_speed(TokenReader& reader, ProgramMove& move) {
    if (reader.accept_word("WELD_SPEED")) return;
    const double value = reader.number("a speed");
    if (value <= 0) reader.fail("a speed that is not above zero", "above zero");
    if (reader.accept_symbol('%')) {
      move.percent = all_percent(value);
    } else if (reader.accept_word("SEC")) {
      move.time = value;
    } else if (reader.accept_word("MSEC")) {
      move.time = value * 1e-3;
    } else {
      const std::string length = reader.word("%, sec, msec, mm/sec, cm/min or inch/min");
      reader.expect_symbol('/');
      const std::string per = reader.word("sec or min");
      if (length == "MM" && (per == "SEC" || per == "S"))
        move.speed = value * 1e-3;
      else if (length == "CM" && per == "MIN")
        move.speed = value * 1e-2 / 60;
      else if (length == "INCH" && per == "MIN")
        move.speed = value * 0.0254 / 60;
      else
        reader.fail("'" + length.substr(0, 20) + "/" + per.substr(0, 20) + "' is not understood",
                    "mm/sec, cm/min or inch/min");
    }
  }

  ProgramMove placed(Target& target, const LsPositions& positions) {
    const auto found = positions.find(target.position);
    if (found == positions.end())
      throw InvalidInput(target.move.where,
                         "no position P[" + std::to_string(target.position) + "]",
                         "it in the section /POS");
    const LsPosition& position = found->second;
    target.move.axes = position.axes;
    target.move.pose = position.pose;
    if (position.pose) {
      if (frame_ && (*frame_ != position.frame || *tool_ != position.tool))
        throw InvalidInput(target.move.where, "another user frame or tool than before",
                           "one of each for all positions");
      frame_ = position.frame;
      tool_ = position.tool;
    }
    return std::move(target.move);
  }

  std::filesystem::path file_;
  int j3_coupling_;
  std::vector<Target> targets_;
  std::optional<double> frame_, tool_;
};

}  // namespace

ProgramMoves read_ls(const std::filesystem::path& file, int j3_coupling) {
  return LsReader(file, j3_coupling).read();
}

}  // namespace wristwise
