// KRL as far as PTP, LIN, SPTP and SLIN go.

#include <algorithm>

#include "import/krl_points.hpp"
#include "io/text_file.hpp"

namespace wristwise {

namespace {

using Words = std::vector<std::string>;

const Words kPointTypes = {"AXIS", "E6AXIS", "POS", "E6POS", "FRAME"};
const Words kJointMoves = {"PTP", "SPTP"}, kLinearMoves = {"LIN", "SLIN"};
/// Lines that neither move nor say how the next move is made.
const Words kLeftOut = {"EXT",    "EXTP",    "SIGNAL",        "CONTINUE", "WAIT",      "HALT",
                        "PULSE",  "TRIGGER", "ANOUT",         "ANIN",     "INTERRUPT", "GLOBAL",
                        "INT",    "REAL",    "BOOL",          "CHAR",     "ENUM",      "STRUC",
                        "IMPORT", "STOP",    "RETURN_TO_PATH"};

bool is_one_of(const Token& token, const Words& words) {
  return token.kind == Token::Kind::word &&
         std::find(words.begin(), words.end(), token.text) != words.end();
}

class KrlReader {
 public:
  void read_declarations(const std::filesystem::path& file) {
    const std::vector<Token> tokens = tokens_of(read_text(file), {';', true});
    TokenReader reader(tokens, file.string());
    while (!reader.at_end()) {
      if (!read_declaration(reader)) reader.skip_line();
    }
  }

  ProgramMoves read_program(const std::filesystem::path& file) {
    const std::vector<Token> tokens = tokens_of(read_text(file), {';', true});
    TokenReader reader(tokens, file.string());
    while (!reader.at_end()) read_line(reader);
    if (timing_) reader.fail("TIME_BLOCK START without END", "TIME_BLOCK END=...");
    return std::move(moves_);
  }

 private:
  void end_line(TokenReader& reader) {
    if (!reader.at_line_end()) reader.not_understood("the end of the line");
    reader.next();
  }

  /// "DECL GLOBAL E6POS XP1={...}" and the like. False where the line declares no point.
  bool read_declaration(TokenReader& reader) {
    std::size_t ahead = 0;
    const Words modifiers = {"DECL", "GLOBAL", "CONST"};
    while (is_one_of(reader.peek(ahead), modifiers)) ++ahead;
    if (!is_one_of(reader.peek(ahead), kPointTypes)) return false;
    for (std::size_t k = 0; k <= ahead; ++k) reader.next();
    do {
      points_.declare(reader);
    } while (reader.accept_symbol(','));
    end_line(reader);
    return true;
  }

  void read_line(TokenReader& reader) {
    const Token first = reader.peek();
    if (read_declaration(reader) || read_frame_of_program(reader)) return;
    if (reader.at_line_end() || reader.at_symbol('&') || reader.at_word("DECL") ||
        is_one_of(first, kLeftOut)) {
      reader.skip_line();
    } else if (is_one_of(first, kJointMoves) || is_one_of(first, kLinearMoves)) {
      read_move(reader);
    } else if (reader.accept_word("TIME_BLOCK")) {
      read_time_block(reader);
    } else if (reader.accept_word("BAS")) {
      read_bas(reader);
    } else if (first.text == "$VEL_AXIS" || first.text == "$VEL_EXTAX") {
      read_axis_speed(reader);
    } else {
      read_assignment(reader);
    }
  }

  /// DEF, END and the brackets of splines.
  bool read_frame_of_program(TokenReader& reader) {
    const Words known = {"DEF", "END", "SPLINE", "PTP_SPLINE", "ENDSPLINE", "INI"};
    if (!is_one_of(reader.peek(), known)) return false;
    if (reader.at_word("DEF") && !moves_.empty())
      reader.fail("a second program in the file", "one");
    if (reader.at_word("DEF"))
      reader.skip_line();
    else {
      reader.next();
      skip_approximation(reader);
      end_line(reader);
    }
    return true;
  }

  static void skip_approximation(TokenReader& reader) {
    const Words approximations = {"C_PTP", "C_DIS", "C_VEL", "C_ORI", "C_SPL"};
    while (is_one_of(reader.peek(), approximations)) reader.next();
  }

  void read_move(TokenReader& reader) {
    ProgramMove move;
    move.linear = is_one_of(reader.next(), kLinearMoves);
    points_.read_target(reader, move);
    skip_approximation(reader);
    end_line(reader);
    if (move.linear)
      move.speed = speed_;
    else
      move.percent = percent_;
    cartesian_ = cartesian_ || move.pose.has_value();
    moves_.push_back(std::move(move));
  }

  // TIME_BLOCK START, a PART in percent after each segment, END = s.
  void read_time_block(TokenReader& reader) {
    if (reader.accept_word("START")) {
      if (timing_) reader.fail("TIME_BLOCK START twice", "END before it");
      timing_ = true;
      shares_.clear();
      first_timed_ = moves_.size();
    } else if (reader.accept_word("PART")) {
      reader.expect_symbol('=');
      shares_.push_back(reader.number("a share in percent"));
      if (!timing_ || first_timed_ + shares_.size() != moves_.size())
        reader.fail("TIME_BLOCK PART", "one after each segment");
    } else if (reader.accept_word("END")) {
      reader.expect_symbol('=');
      end_time_block(reader.number("a time in s"), reader);
    } else {
      reader.not_understood("START, PART or END");
    }
    end_line(reader);
  }

  void end_time_block(double duration, const TokenReader& reader) {
    if (!timing_ || shares_.empty() || first_timed_ + shares_.size() != moves_.size())
      reader.fail("TIME_BLOCK END", "TIME_BLOCK PART after each segment");
    double sum = 0;
    for (const double share : shares_) {
      if (share <= 0) reader.fail("a share that is not above zero", "shares above zero");
      sum += share;
    }
    if (duration <= 0) reader.fail("a time that is not above zero", "a time in s");
    for (std::size_t k = 0; k < shares_.size(); ++k)
      moves_[first_timed_ + k].time = duration * shares_[k] / sum;
    timing_ = false;
  }

  /// BAS(#VEL_PTP,30): the default speeds.
  void read_bas(TokenReader& reader) {
    reader.expect_symbol('(');
    reader.expect_symbol('#');
    const std::string command = reader.word("a command of BAS");
    double value = 0;
    if (reader.accept_symbol(',')) value = reader.number("its value");
    reader.expect_symbol(')');
    if (command == "INITMOV")
      percent_ = all_percent(100);
    else if (command == "VEL_PTP" || command == "PTP_PARAMS")
      percent_ = all_percent(checked_percent(value, reader));
    else if (command == "VEL_CP" || command == "CP_PARAMS")
      speed_ = checked_speed(value, reader);
    else if (command == "TOOL" || command == "BASE" || command == "FRAMES")
      expect_no_pose_yet("#" + command, reader);
    end_line(reader);
  }

  void read_axis_speed(TokenReader& reader) {
    const std::size_t first = reader.next().text == "$VEL_AXIS" ? 0 : kRobotAxes;
    reader.expect_symbol('[');
    const double index = reader.number("the number of an axis");
    if (index != 1 && index != 2 && index != 3 && index != 4 && index != 5 && index != 6)
      reader.fail("no such axis", "1 to 6");
    reader.expect_symbol(']');
    reader.expect_symbol('=');
    percent_[first + static_cast<std::size_t>(index) - 1] =
        checked_percent(reader.number("a percentage"), reader);
    end_line(reader);
  }

  static double checked_percent(double value, const TokenReader& reader) {
    if (!(value > 0 && value <= 100)) reader.fail("a speed out of range", "1 to 100 percent");
    return value;
  }

  static double checked_speed(double value, const TokenReader& reader) {
    if (value <= 0) reader.fail("a speed that is not above zero", "m/s");
    return value;
  }

  /// Poses of one program are all in one base, with one tool.
  void expect_no_pose_yet(const std::string& what, const TokenReader& reader) const {
    if (cartesian_) reader.fail(what + " changes between moves to poses", "one tool and one base");
  }

  /// NAME = ..., $VEL.CP = ..., XP1 = {...}; a call may move, so it is not understood.
  void read_assignment(TokenReader& reader) {
    const Token name = reader.peek();
    const std::string after = reader.peek(1).text;
    const bool point = points_.has(name.text);
    const bool assigns = after == "=" || (!point && (after == "." || after == "["));
    if (name.kind != Token::Kind::word || !assigns || (name.text == "$VEL" && after == "="))
      reader.not_understood("PTP, LIN, SPTP, SLIN, declarations and speeds");
    if (name.text == "$BASE" || name.text == "$TOOL") expect_no_pose_yet(name.text, reader);
    if (point) {
      points_.declare(reader);
      end_line(reader);
    } else if (name.text == "$VEL" && reader.peek(2).text == "CP") {
      read_path_speed(reader);
    } else {
      reader.skip_line();
    }
  }

  /// $VEL.CP=0.01
  void read_path_speed(TokenReader& reader) {
    for (int k = 0; k < 3; ++k) reader.next();
    reader.expect_symbol('=');
    speed_ = checked_speed(reader.number("m/s"), reader);
    end_line(reader);
  }

  KrlPoints points_;
  ProgramMoves moves_;
  AxisValues percent_ = all_percent(100);
  std::optional<double> speed_;
  bool cartesian_ = false;
  bool timing_ = false;
  std::size_t first_timed_ = 0;
  std::vector<double> shares_;
};

}  // namespace

ProgramMoves read_krl(const std::filesystem::path& file) {
  KrlReader reader;
  for (const char* extension : {".dat", ".DAT", ".Dat"}) {
    std::filesystem::path declarations = file;
    declarations.replace_extension(extension);
    std::error_code error;
    if (!std::filesystem::is_regular_file(declarations, error)) continue;
    reader.read_declarations(declarations);
    break;
  }
  return reader.read_program(file);
}

}  // namespace wristwise
