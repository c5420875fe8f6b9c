#pragma once

#include <string>
#include <vector>

namespace wristwise {

/// Text of YAML as ROS 2 prints it, that is, as Python's yaml.dump writes it in block style.
class RosYaml {
 public:
  /// @param dash the line begins an item of a list
  void key(int indent, const std::string& name, bool dash = false);
  void value(int indent, const std::string& name, const std::string& text, bool dash = false);
  void empty_list(int indent, const std::string& name);
  void numbers(int indent, const std::string& name, const double* values, std::size_t count,
               bool dash = false);
  void words(int indent, const std::string& name, const std::vector<std::string>& words);

  const std::string& text() const { return text_; }

 private:
  std::string text_;
};

/// As Python's repr, with the point that YAML wants: "0.1", "1.0e-05", "100.0".
std::string yaml_number(double value);

/// Quoted where it would be read as something else.
std::string yaml_word(const std::string& word);

}  // namespace wristwise
