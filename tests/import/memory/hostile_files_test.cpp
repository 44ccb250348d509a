#include "tests/import/memory/hostile_files.h"

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/import/memory/import_apart.h"
#include "tests/import/memory/packed_zeros.h"
#include "tests/sanitized.h"

// Small files that ask for much memory are refused before they get it, or are read in little.

namespace throng::import::testing::hostile_files_test {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::StartsWith;

std::uint64_t size_beside(const std::filesystem::path& model) {
  std::uint64_t size = 0;
  for (const auto& file : std::filesystem::directory_iterator(model.parent_path())) size += file.file_size();
  return size;
}

/// What an import may hold: 64 MB and four times the files, and what a tree of the JSON takes.
std::uint64_t memory_for(const std::filesystem::path& model) {
  constexpr std::uint64_t slack = 16'000'000;  // of the heap
  const std::uint64_t json = std::filesystem::file_size(model);
  return 64'000'000 + 4 * size_beside(model) + std::min<std::uint64_t>(32 * json, 256'000'000) + slack;
}

constexpr std::uint64_t times = throng::test::sanitized ? 6 : 1;  // a sanitizer keeps what was freed

class Hostile : public ::testing::TestWithParam<HostileFile> {
 protected:
  TemporaryFolder folder_;
};

TEST_P(Hostile, HoldsNoMoreThanItsFilesAllow) {
  const std::filesystem::path model = GetParam().write(folder_);
  const ImportApart imported = import_apart(model);
  EXPECT_LE(imported.peak, memory_for(model) * times);
  if (GetParam().object.empty()) {
    EXPECT_THAT(imported.message, IsEmpty());
  } else {
    EXPECT_THAT(imported.message, AllOf(StartsWith(model.string() + ": "), HasSubstr(GetParam().object),
                                        HasSubstr(" of memory, and "), HasSubstr("--memory-limit")));
  }
}

INSTANTIATE_TEST_SUITE_P(File, Hostile, ::testing::ValuesIn(hostile_files()),
                         [](const ::testing::TestParamInfo<HostileFile>& file) { return file.param.name; });

/// A model that shows one image of 4,096 pixels squared, in a file of 15 KB.
std::filesystem::path write_flat_image(const TemporaryFolder& folder) {
  return write_with_image(folder, "skin.png", png_of_zeros(4096, 4096, false));
}

/// What images may hold besides, however small their files are, and what a decoder may.
constexpr std::uint64_t memory_for_images = 2'000'000'000;

TEST(DenseImage, IsReadHoweverSmallItsFileIs) {
  for (const bool is_jpeg : {false, true}) {
    const TemporaryFolder folder;
    const auto bytes = is_jpeg ? jpeg_of_zeros(8192, 8192) : webp_of_zeros(8192, 8192);
    const std::filesystem::path model = write_with_image(folder, "skin.png", bytes);
    const ImportApart imported = import_apart(model);
    EXPECT_THAT(imported.message, IsEmpty());
    EXPECT_LE(imported.peak, (memory_for(model) + memory_for_images) * times);
  }
}

TEST(DenseImage, OfFlatColourIsWhole) {
  const TemporaryFolder folder;
  const anim::ImportedFile file = import_good(write_flat_image(folder));
  EXPECT_EQ(file.models.at(0).images.at(0).width, 4096);
  EXPECT_THAT(file.repairs, IsEmpty());
}

TEST(DenseImages, ThatTakeTooMuchTogetherAreScaledDownAndSaid) {
  const TemporaryFolder folder;
  const std::filesystem::path model = write_with_images(folder, 17, png_of_zeros(4096, 4096, false));
  EXPECT_LE(import_apart(model).peak, (memory_for(model) + memory_for_images) * times);
  const anim::ImportedFile file = import_good(model);
  EXPECT_EQ(file.models.at(0).images.front().width, 2048);
  EXPECT_EQ(file.models.at(0).images.back().width, 4096) << "which has what the others left";
  ASSERT_FALSE(file.repairs.empty());
  EXPECT_EQ(
      file.repairs.front(),
      "image 0 \"skin\": scaled down from 4096 by 4096 to 2048 by 2048 pixels, because the images of its file "
      "would take too much memory; a larger memory limit (--memory-limit, LoadOptions::memory_limit) allows more");
}

TEST(MemoryLimit, OfTheCallerAllowsMore) {
  const TemporaryFolder folder;
  const std::filesystem::path model = write_flat_image(folder);
  EXPECT_THAT(import_apart(model, {.memory_limit = 66'000'000}).message, HasSubstr("image 0 \"skin\" needs 67.1 MB"));
  EXPECT_THAT(import_apart(model, {.memory_limit = 500'000'000}).message, IsEmpty());
}

TEST(MemoryLimit, OfTheCallerAllowsLess) {
  const std::filesystem::path model = data_path("features/data-uri.gltf");
  EXPECT_THAT(import_apart(model, {.memory_limit = 1000}).message,
              AllOf(HasSubstr("the file needs "), HasSubstr("of the 1000 bytes that the import may take")));
  EXPECT_THAT(import_apart(model, {.memory_limit = 1'000'000}).message, IsEmpty());
}

TEST(MemoryLimit, OfTheCallerCountsImagesWhole) {
  const TemporaryFolder folder;
  const std::filesystem::path model = write_flat_image(folder);
  EXPECT_THAT(import_apart(model, {.memory_limit = 64'000'000}).message, HasSubstr("of the 64.0 MB"));
}

TEST(SkinOfManyJoints, IsRefusedBeforeItIsRead) {
  const TemporaryFolder folder;
  const std::filesystem::path model = write_skins_of_many_joints(folder);
  const ImportApart imported = import_apart(model);
  EXPECT_THAT(imported.message, HasSubstr("skin 1: has 70000 joints, and 1024 are the most; split the model"));
  EXPECT_LE(imported.peak, (64'000'000 + 4 * size_beside(model)) * times);
}

TEST(SharedImage, IsOneImageOfTheModel) {
  const TemporaryFolder folder;
  const auto shared = std::ranges::find(hostile_files(), "ImageThatManyShow", &HostileFile::name);
  const anim::ImportedFile file = import_good(shared->write(folder));
  EXPECT_EQ(file.models.at(0).images.size(), 1U);
  EXPECT_EQ(file.models.at(0).materials.back().base_color_texture.image, 0);
}

TEST(SharedImage, IsHeldOnceByAllModels) {
  const TemporaryFolder folder;
  const auto shared = std::ranges::find(hostile_files(), "ImageOfManySkeletons", &HostileFile::name);
  const anim::ImportedFile file = import_good(shared->write(folder));
  ASSERT_GT(file.models.size(), 1U);
  EXPECT_EQ(file.models.front().images.at(0).rgba.data(), file.models.back().images.at(0).rgba.data());
}

TEST(PngStream, ThatHoldsMoreThanItsHeaderSaysIsLeftOut) {
  const TemporaryFolder folder;
  const auto png = std::ranges::find(hostile_files(), "PngThatInflates", &HostileFile::name);
  EXPECT_THAT(import_good(png->write(folder)).repairs,
              ::testing::ElementsAre(HasSubstr("its stream holds more than an image of its size needs")));
}

TEST(PngStream, ThatHoldsLittleMoreIsDecoded) {
  const TemporaryFolder folder;
  EXPECT_THAT(import_good(write_with_image(folder, "skin.png", png_of_zeros(64, 64, true, 1000))).repairs, IsEmpty());
}

TEST(LongName, IsCutBetweenLetters) {
  const TemporaryFolder folder;
  nlohmann::json document = editable_document();
  std::string name = "n";
  for (int i = 0; i < 1000; ++i) name += "\xC3\xA9";
  document["animations"][0]["name"] = name;
  const anim::ImportedFile file = import_good(folder.write("model.gltf", document.dump()));
  EXPECT_EQ(file.animations.at(0), name.substr(0, 1023));
}

}  // namespace
}  // namespace throng::import::testing::hostile_files_test
