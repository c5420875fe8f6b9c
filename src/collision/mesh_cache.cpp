#include "collision/mesh_cache.hpp"

#include <unistd.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cstring>
#include <fstream>
#include <iterator>

#include "content_hash.hpp"

namespace wristwise {

namespace {

// One more wherever the pieces that are found for a file change.
constexpr std::uint32_t kVersion = 1;
constexpr std::uint64_t kMagic = 0x6863617369727720;  // the order of bytes is part of the format
constexpr std::uint32_t kMost = 1U << 24;

std::string bytes_of(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

class Writer {
 public:
  template <class Value>
  void put(const Value& value) {
    static_assert(std::is_trivially_copyable_v<Value>);
    text_.append(reinterpret_cast<const char*>(&value), sizeof value);
  }
  void put_text(const std::string& text) {
    put(static_cast<std::uint32_t>(text.size()));
    text_ += text;
  }
  const std::string& text() const { return text_; }

 private:
  std::string text_;
};

/// Reads what a Writer wrote; `sound` turns false where there is too little.
class Reader {
 public:
  explicit Reader(const std::string& text) : text_(text) {}

  template <class Value>
  Value get() {
    Value value{};
    if (text_.size() - at_ < sizeof value) {
      sound_ = false;
      return value;
    }
    std::memcpy(&value, text_.data() + at_, sizeof value);
    at_ += sizeof value;
    return value;
  }
  std::uint32_t count() {
    const auto count = get<std::uint32_t>();
    if (count > kMost) sound_ = false;
    return sound_ ? count : 0;
  }
  std::string get_text() {
    const std::uint32_t size = count();
    if (text_.size() - at_ < size) sound_ = false;
    if (!sound_) return {};
    at_ += size;
    return text_.substr(at_ - size, size);
  }
  bool sound() const { return sound_; }
  bool at_end() const { return at_ == text_.size(); }

 private:
  const std::string& text_;
  std::size_t at_ = 0;
  bool sound_ = true;
};

void put_hull(Writer& writer, const ConvexHull& hull) {
  writer.put(static_cast<std::uint32_t>(hull.vertices.size()));
  for (const Eigen::Vector3d& v : hull.vertices) {
    for (const double x : v) writer.put(x);
  }
  writer.put(static_cast<std::uint32_t>(hull.triangles.size()));
  for (const auto& triangle : hull.triangles) writer.put(triangle);
}

bool get_hull(Reader& reader, ConvexHull& hull) {
  const std::uint32_t vertices = reader.count();
  for (std::uint32_t v = 0; v < vertices && reader.sound(); ++v) {
    const auto x = reader.get<double>(), y = reader.get<double>(), z = reader.get<double>();
    hull.vertices.emplace_back(x, y, z);
    if (!hull.vertices.back().allFinite()) return false;
  }
  const std::uint32_t triangles = reader.count();
  for (std::uint32_t t = 0; t < triangles && reader.sound(); ++t) {
    hull.triangles.push_back(reader.get<std::array<int, 3>>());
    for (const int corner : hull.triangles.back()) {
      if (corner < 0 || corner >= static_cast<int>(vertices)) return false;
    }
  }
  return reader.sound() && vertices >= 4;
}

using Hash = std::array<std::uint64_t, 2>;

std::string sealed(const std::string& content, const Hash& key) {
  Writer file;
  file.put(kMagic);
  file.put(kVersion);
  file.put(key);
  file.put(content_hash(content));
  file.put_text(content);
  return file.text();
}

/// nullopt where the file is of another key or version, cut off or changed.
std::optional<std::string> unsealed(const std::string& file, const Hash& key) {
  Reader reader(file);
  if (reader.get<std::uint64_t>() != kMagic || reader.get<std::uint32_t>() != kVersion ||
      reader.get<Hash>() != key) {
    return std::nullopt;
  }
  const auto sum = reader.get<Hash>();
  std::string content = reader.get_text();
  if (!reader.sound() || !reader.at_end() || content_hash(content) != sum) return std::nullopt;
  return content;
}

std::optional<MeshBody> body_of(const std::string& content) {
  Reader reader(content);
  MeshBody body;
  const bool measured = reader.get<std::uint8_t>() != 0;
  const auto error = reader.get<double>();
  if (measured) body.error = error;
  body.pieces.resize(reader.count());
  for (ConvexHull& piece : body.pieces) {
    if (!get_hull(reader, piece)) return std::nullopt;
  }
  const std::uint32_t warnings = reader.count();
  for (std::uint32_t w = 0; w < warnings; ++w) body.warnings.push_back(reader.get_text());
  if (!reader.sound() || !reader.at_end() || body.pieces.empty()) return std::nullopt;
  return body;
}

}  // namespace

MeshCache::MeshCache(const std::filesystem::path& file, const Eigen::Vector3d& scale,
                     const MeshOptions& options)
    : folder_(options.cache), where_(file.string()) {
  // Other formats may refer to further files.
  std::string extension = file.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  const bool self_contained = extension == ".stl" || extension == ".obj" || extension == ".dae";
  std::error_code error;
  if (!self_contained || !std::filesystem::is_regular_file(file, error)) folder_.clear();
  if (folder_.empty()) return;
  Writer settings;
  settings.put(kVersion);
  settings.put_text(extension);
  for (const double factor : scale) settings.put(factor);
  settings.put(options.convex_error.value_or(0));
  settings.put(options.sheet);
  settings.put(options.turn_up_axis);
  key_ = content_hash(settings.text() + bytes_of(file));
}

std::filesystem::path MeshCache::place() const {
  constexpr const char* kDigits = "0123456789abcdef";
  std::string name;
  for (const std::uint64_t half : key_) {
    for (int shift = 60; shift >= 0; shift -= 4) name += kDigits[(half >> shift) & 15U];
  }
  return folder_ / (name + ".pieces");
}

std::optional<MeshBody> MeshCache::find() const {
  std::error_code ignored;
  if (folder_.empty() || !std::filesystem::is_regular_file(place(), ignored)) return std::nullopt;
  const auto content = unsealed(bytes_of(place()), key_);
  if (!content) return std::nullopt;
  auto body = body_of(*content);
  if (!body) return std::nullopt;
  for (std::string& warning : body->warnings) warning.insert(0, where_);
  return body;
}

// First whole under another name: a reader never sees half a file.
void MeshCache::keep(const MeshBody& body) const {
  if (folder_.empty()) return;
  Writer content;
  content.put(static_cast<std::uint8_t>(body.error.has_value()));
  content.put(body.error.value_or(0));
  content.put(static_cast<std::uint32_t>(body.pieces.size()));
  for (const ConvexHull& piece : body.pieces) put_hull(content, piece);
  content.put(static_cast<std::uint32_t>(body.warnings.size()));
  for (const std::string& warning : body.warnings) content.put_text(warning.substr(where_.size()));
  std::error_code error;
  std::filesystem::create_directory(folder_, error);
  const std::filesystem::path unfinished =
      place().string() + "." + std::to_string(getpid()) + ".tmp";
  {
    std::ofstream stream(unfinished, std::ios::binary);
    stream << sealed(content.text(), key_);
    stream.close();
    if (!stream) {
      std::filesystem::remove(unfinished, error);
      return;
    }
  }
  std::filesystem::rename(unfinished, place(), error);
  if (error) std::filesystem::remove(unfinished, error);
}

}  // namespace wristwise
