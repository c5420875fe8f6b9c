#include <gtest/gtest.h>

#include <filesystem>

#include "invalid_input.hpp"
#include "kinematics/urdf_collision.hpp"
#include "temporary_folder.hpp"

namespace wristwise {
namespace {

using test::invalid_input;
using test::says;
using test::TemporaryFolder;

TEST(ResolveMesh, SearchesPackagesAndRelativePaths) {
  const TemporaryFolder folder;
  std::filesystem::create_directories(folder.path() / "my_robot" / "meshes");
  const auto mesh = folder.write("my_robot/meshes/a.stl", "solid");
  const auto same = [&](const std::string& uri, const MeshFolders& folders) {
    return std::filesystem::equivalent(resolve_mesh(uri, folders, "test"), mesh);
  };
  const std::string uri = "package://my_robot/meshes/a.stl";
  EXPECT_TRUE(same(uri, {"/", {"/nowhere", folder.path()}}));   // contains the package
  EXPECT_TRUE(same(uri, {"/", {folder.path() / "my_robot"}}));  // is the package
  EXPECT_TRUE(same(uri, {"/", {(folder.path() / "my_robot").string() + "/"}}));
  EXPECT_TRUE(same("meshes/a.stl", {folder.path() / "my_robot", {}}));
  EXPECT_TRUE(same("file://" + mesh.string(), {"/", {}}));
  const std::string missing = invalid_input([&] {
    resolve_mesh("package://other/a.stl", {"/", {folder.path()}}, "test");
  });
  EXPECT_TRUE(says(missing, "package://other/a.stl") && says(missing, folder.path().string()));
}

}  // namespace
}  // namespace wristwise
