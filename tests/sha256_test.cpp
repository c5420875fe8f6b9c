#include "io/sha256.hpp"

#include <gtest/gtest.h>

#include <cstdio>
#include <memory>

#include "invalid_input.hpp"
#include "io/input_file.hpp"
#include "temporary_folder.hpp"

namespace wristwise {
namespace {

using test::TemporaryFolder;

// The examples of FIPS 180-4.
TEST(Sha256, GivesTheDigestsOfTheStandard) {
  EXPECT_EQ(sha256(""), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
  EXPECT_EQ(sha256("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  EXPECT_EQ(sha256("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq"),
            "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1");
  EXPECT_EQ(sha256(std::string(1000000, 'a')),
            "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
}

std::string sha256sum(const std::filesystem::path& file) {
  const std::string command = "sha256sum '" + file.string() + "'";
  const std::unique_ptr<FILE, int (*)(FILE*)> pipe(popen(command.c_str(), "r"), pclose);
  char digits[65] = {};
  if (std::fread(digits, 1, 64, pipe.get()) != 64) return "";
  return digits;
}

// Lengths around the ends of blocks, with every value of a byte.
TEST(Sha256, AgreesWithSha256sum) {
  const TemporaryFolder folder;
  for (const std::size_t length : {1U, 55U, 56U, 63U, 64U, 65U, 119U, 120U, 128U, 1000U}) {
    std::string bytes;
    for (std::size_t i = 0; i < length; ++i) bytes += static_cast<char>(i * 37 + length);
    EXPECT_EQ(sha256(bytes), sha256sum(folder.write("bytes", bytes))) << length;
  }
}

TEST(InputFiles, AreHashedOnceEach) {
  const TemporaryFolder folder;
  const auto a = folder.write("a.yaml", "abc");
  const auto b = folder.write("b.csv", "");
  const auto inputs = input_files({a, b, folder.path() / "." / "a.yaml"});
  ASSERT_EQ(inputs.size(), 2U);
  EXPECT_EQ(inputs[0].name, a.string());
  EXPECT_EQ(inputs[0].bytes, 3U);
  EXPECT_EQ(inputs[0].sha256, sha256("abc"));
  EXPECT_EQ(inputs[1].bytes, 0U);
  const std::string message =
      test::invalid_input([&] { input_files({folder.path() / "none.stl"}); });
  EXPECT_NE(message.find("none.stl"), std::string::npos) << message;
}

}  // namespace
}  // namespace wristwise
