#include <gtest/gtest.h>

#include <random>

#include "mesh_samples.hpp"
#include "wristwise/mesh.hpp"

namespace wristwise {
namespace {

namespace fs = std::filesystem;
using test::file_text;
using test::TemporaryFolder;

const std::vector<Eigen::Vector2d> kLetterL{{0, 0},   {200, 0},  {200, 10},
                                            {10, 10}, {10, 200}, {0, 200}};

void expect_same(const MeshBody& a, const MeshBody& b) {
  EXPECT_EQ(a.error, b.error);
  EXPECT_EQ(a.warnings, b.warnings);
  ASSERT_EQ(a.pieces.size(), b.pieces.size());
  for (std::size_t i = 0; i < a.pieces.size(); ++i) {
    EXPECT_EQ(a.pieces[i].vertices, b.pieces[i].vertices);  // every bit
    EXPECT_EQ(a.pieces[i].triangles, b.pieces[i].triangles);
  }
}

class MeshCache : public testing::Test {
 protected:
  MeshCache() : mesh_(folder_.write("l.stl", test::binary_stl(test::prism(kLetterL, 400)))) {
    options_.convex_error = 0.002;
    options_.cache = folder_.path() / ".cache";
    fresh_ = load(false);
  }

  MeshBody load(bool with_cache = true, double scale = 0.001) const {
    MeshOptions options = options_;
    if (!with_cache) options.cache.clear();
    return load_mesh(mesh_, {scale, scale, scale}, options);
  }

  std::vector<fs::path> entries() const {
    std::vector<fs::path> found;
    if (!fs::exists(options_.cache)) return found;
    for (const auto& entry : fs::directory_iterator(options_.cache)) found.push_back(entry.path());
    return found;
  }

  TemporaryFolder folder_;
  fs::path mesh_;
  MeshOptions options_;
  MeshBody fresh_;
};

TEST_F(MeshCache, GivesWhatWasFoundBitForBit) {
  EXPECT_TRUE(entries().empty());
  expect_same(load(), fresh_);
  ASSERT_EQ(entries().size(), 1U);
  EXPECT_EQ(entries()[0].extension(), ".pieces");
  expect_same(load(), fresh_);
  EXPECT_EQ(entries().size(), 1U);
}

TEST_F(MeshCache, IsUsed) {
  load();
  const fs::path entry = entries().at(0);
  fs::permissions(entry, fs::perms::owner_read);
  const auto time = fs::last_write_time(entry);
  load();
  EXPECT_EQ(fs::last_write_time(entry), time);
}

TEST_F(MeshCache, IsKeyedByContentScaleAndSettings) {
  load();
  load(true, 0.002);
  EXPECT_EQ(entries().size(), 2U);
  options_.convex_error = 0.003;
  load();
  EXPECT_EQ(entries().size(), 3U);
  options_.convex_error.reset();
  load();
  options_.sheet = true;
  load();
  EXPECT_EQ(entries().size(), 5U);
  folder_.write("l.stl", test::binary_stl(test::prism(kLetterL, 401)));
  load();
  EXPECT_EQ(entries().size(), 6U);
  const fs::path moved = folder_.path() / "other_name.stl";
  fs::rename(mesh_, moved);
  mesh_ = moved;
  load();
  EXPECT_EQ(entries().size(), 6U);  // the same content
}

TEST_F(MeshCache, WarningsNameTheFileAsItIsCalledNow) {
  mesh_ = folder_.write("mm.stl", test::binary_stl(test::prism(kLetterL, 400)));
  load(true, 1);
  const fs::path moved = folder_.path() / "moved.stl";
  fs::rename(mesh_, moved);
  mesh_ = moved;
  const MeshBody body = load(true, 1);
  ASSERT_EQ(body.warnings.size(), 1U);
  EXPECT_EQ(body.warnings[0].find(moved.string() + ": "), 0U) << body.warnings[0];
}

TEST_F(MeshCache, DamagedEntriesAreAsIfThereWereNone) {
  load();
  const fs::path entry = entries().at(0);
  const std::string whole = file_text(entry);
  std::mt19937 random(76);
  for (int sample = 0; sample < 120; ++sample) {
    std::string damaged = whole;
    if (sample % 3 == 0) {
      damaged.resize(random() % whole.size());
    } else if (sample % 3 == 1) {
      char& c = damaged[random() % damaged.size()];
      c = static_cast<char>(c ^ static_cast<char>(1 << random() % 8));
    } else {
      damaged += "more";
    }
    std::ofstream(entry, std::ios::binary) << damaged;
    expect_same(load(), fresh_);
    ASSERT_EQ(file_text(entry), whole);  // mended
  }
}

TEST_F(MeshCache, WhatCannotBeWrittenIsPassedOver) {
  options_.cache = folder_.write("a_file_is_no_folder", "");
  expect_same(load(), fresh_);
  options_.cache = "/proc/no_such_place/cache";
  expect_same(load(), fresh_);
  options_.cache = folder_.path() / "cache";
  load();
  const fs::path entry = fs::directory_iterator(options_.cache)->path();
  fs::remove(entry);
  fs::create_directory(entry);  // in the place of the file
  expect_same(load(), fresh_);
}

}  // namespace
}  // namespace wristwise
