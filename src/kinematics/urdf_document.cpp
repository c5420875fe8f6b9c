#include "kinematics/urdf_document.hpp"

#include <console_bridge/console.h>
#include <tinyxml.h>
#include <urdf_parser/urdf_parser.h>

#include <exception>
#include <mutex>

#include "kinematics/urdf_cleaning.hpp"
#include "wristwise/error.hpp"

namespace wristwise {
namespace {

/// Collects what urdfdom would print. Its log is one per process, hence the lock.
class ParserLog : public console_bridge::OutputHandler {
 public:
  ParserLog() : lock_(mutex()) { console_bridge::useOutputHandler(this); }
  ~ParserLog() override { console_bridge::restorePreviousOutputHandler(); }
  ParserLog(const ParserLog&) = delete;
  ParserLog& operator=(const ParserLog&) = delete;

  void log(const std::string& text, console_bridge::LogLevel level, const char*, int) override {
    if (level >= console_bridge::CONSOLE_BRIDGE_LOG_WARN) messages_.push_back(one_line(text));
  }

  const std::vector<std::string>& messages() const { return messages_; }
  std::string joined() const {
    std::string text;
    for (const std::string& message : messages_) text += (text.empty() ? "" : ", ") + message;
    return text.empty() ? "the parser gives no reason" : text;
  }

 private:
  static std::mutex& mutex() {
    static std::mutex instance;
    return instance;
  }
  static std::string one_line(std::string text) {
    for (char& c : text) {
      if (c == '\n' || c == '\r') c = ' ';
    }
    return text;
  }

  std::lock_guard<std::mutex> lock_;
  std::vector<std::string> messages_;
};

void load_xml(TiXmlDocument& document, const RobotSource& source) {
  const std::string where = urdf_name(source);
  if (source.urdf_text.empty()) {
    std::error_code error;
    if (!std::filesystem::is_regular_file(source.urdf, error)) {
      throw InvalidInput(where, "no such file", "a URDF file");
    }
    document.LoadFile(where);
  } else {
    document.Parse(source.urdf_text.c_str());
  }
  if (!document.Error()) return;
  throw InvalidInput(where + ":" + std::to_string(document.ErrorRow()),
                     std::string("not valid XML: ") + document.ErrorDesc(), "a URDF file");
}

/// urdfdom refuses a joint whose limit has no effort or velocity, or that has no limit at all, and
/// takes zeros for positions that are not given. The limits file may supply all of them, so we note
/// what is there and fill the rest in for the parser.
DeclaredLimits complete_limits(TiXmlElement& joint) {
  TiXmlElement* limit = joint.FirstChildElement("limit");
  if (limit == nullptr) {
    limit = joint.InsertEndChild(TiXmlElement("limit"))->ToElement();
  }
  DeclaredLimits declared;
  declared.position = limit->Attribute("lower") != nullptr || limit->Attribute("upper") != nullptr;
  declared.velocity = limit->Attribute("velocity") != nullptr;
  if (!declared.velocity) limit->SetAttribute("velocity", "0");
  if (limit->Attribute("effort") == nullptr) limit->SetAttribute("effort", "0");
  return declared;
}

std::map<std::string, DeclaredLimits> complete_all_limits(TiXmlElement& robot) {
  std::map<std::string, DeclaredLimits> declared;
  for (TiXmlElement* joint = robot.FirstChildElement("joint"); joint != nullptr;
       joint = joint->NextSiblingElement("joint")) {
    const char* name = joint->Attribute("name");
    const char* type = joint->Attribute("type");
    if (name == nullptr || type == nullptr) continue;
    const std::string kind = type;
    if (kind == "revolute" || kind == "prismatic" || kind == "continuous") {
      declared[name] = complete_limits(*joint);
    }
  }
  return declared;
}

urdf::ModelInterfaceSharedPtr parse(const std::string& xml, const ParserLog& log,
                                    const std::string& where) {
  urdf::ModelInterfaceSharedPtr model;
  try {
    model = urdf::parseURDF(xml);
  } catch (const std::exception& error) {
    throw InvalidInput(where, error.what(), "a URDF file");
  }
  if (!model || !model->getRoot()) throw InvalidInput(where, log.joined(), "a URDF file");
  return model;
}

/// urdfdom leaves out a collision element that it cannot read; a robot without it would look clear.
void require_all_collisions(const TiXmlElement& robot, const urdf::ModelInterface& model,
                            const ParserLog& log, const std::string& where) {
  for (const TiXmlElement* link = robot.FirstChildElement("link"); link != nullptr;
       link = link->NextSiblingElement("link")) {
    std::size_t count = 0;
    for (const TiXmlElement* shape = link->FirstChildElement("collision"); shape != nullptr;
         shape = shape->NextSiblingElement("collision")) {
      ++count;
    }
    const char* name = link->Attribute("name");
    const auto parsed = name == nullptr ? nullptr : model.getLink(name);
    if (!parsed || parsed->collision_array.size() != count) {
      throw InvalidInput(where, log.joined(),
                         "collision elements of box, cylinder, sphere or mesh");
    }
  }
}

}  // namespace

std::string urdf_name(const RobotSource& source) {
  return source.urdf.empty() && !source.urdf_text.empty() ? "urdf_text" : source.urdf.string();
}

UrdfDocument read_urdf(const RobotSource& source) {
  TiXmlDocument document;
  load_xml(document, source);
  const std::string where = urdf_name(source);
  TiXmlElement* robot = document.FirstChildElement("robot");
  if (robot == nullptr) throw InvalidInput(where, "no <robot> element", "a URDF file");

  require_expanded_tree(*robot, where);
  UrdfDocument result;
  result.only_visual = clean_urdf(*robot, source.visual_as_collision);
  result.declared = complete_all_limits(*robot);
  TiXmlPrinter printer;
  document.Accept(&printer);
  const ParserLog log;
  result.model = parse(printer.Str(), log, where);
  require_all_collisions(*robot, *result.model, log, where);
  result.warnings = log.messages();
  return result;
}

}  // namespace wristwise
