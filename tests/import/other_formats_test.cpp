#include "engine/anim/import/other_formats.h"

#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/import/test_files.h"

namespace throng::import::testing::other_formats_test {
namespace {

using ::testing::HasSubstr;

struct Foreign {
  std::string file;
  std::string begin;
  std::string what;
};

class OtherFormat : public ::testing::TestWithParam<Foreign> {};

TEST_P(OtherFormat, IsNamedWithTheWayToConvertIt) {
  const TemporaryFolder folder;
  const std::string message = message_of(folder.write(GetParam().file, GetParam().begin + " and more"));
  EXPECT_THAT(message, HasSubstr("it is " + GetParam().what));
  EXPECT_THAT(message, HasSubstr("; "));
  EXPECT_THAT(message, ::testing::Not(HasSubstr("JSON")));
}

INSTANTIATE_TEST_SUITE_P(
    ByContentsOrName, OtherFormat,
    ::testing::Values(
        Foreign{"a.fbx", "Kaydara FBX Binary  ", "an FBX file"},
        Foreign{"named.glb", "Kaydara FBX Binary  ", "an FBX file"},
        Foreign{"text.fbx", "; FBX 7.4.0 project file", "an FBX file"}, Foreign{"a.usdz", "PK\x03\x04", "a USDZ file"},
        Foreign{"deep.usdz", std::string(200, '['), "a USDZ file"}, Foreign{"A.USDA", "#usda 1.0", "a USD file"},
        Foreign{"a.usdc", "PXR-USDC", "a USD file"},
        Foreign{"a.dae", "<?xml version=\"1.0\"?>\n<COLLADA xmlns=", "a COLLADA file"},
        Foreign{"xml", "\xEF\xBB\xBF<?xml?>\n<COLLADA>", "a COLLADA file"},
        Foreign{"a.obj", "# Blender\nv 0 0 0", "a Wavefront OBJ file"},
        Foreign{"a.bvh", "HIERARCHY\nROOT Hips", "a BVH motion file"},
        Foreign{"a.blend", "BLENDER-v300", "a Blender file"},
        Foreign{"packed.blend", "\x28\xB5\x2F\xFD", "a Blender file"},
        Foreign{"a.max", "\xD0\xCF\x11\xE0", "a 3ds Max file"}, Foreign{"a.ma", "//Maya ASCII 2020", "a Maya file"},
        Foreign{"a.pmx", "PMX ", "an MMD file"}, Foreign{"a.zip", "PK\x03\x04", "an archive"},
        Foreign{"noname", "PK\x03\x04", "an archive"}, Foreign{"a.glb", "<!DOCTYPE html><html>", "a web page"},
        Foreign{"lfs.glb", "version https://git-lfs.github.com/spec/v1", "a pointer of Git LFS"},
        Foreign{"a.png", "\x89PNG\r\n", "a picture"}, Foreign{"a.h5", "\x89HDF\r\n\x1A\n", "an HDF5 file"},
        Foreign{"named2.glb", "PAR1", "a Parquet table"}, Foreign{"a.npy", "\x93NUMPY", "an array of NumPy"},
        Foreign{"a.sqlite", std::string("SQLite format 3\0", 16), "a database of SQLite"},
        Foreign{"a.xlsx", "PK\x03\x04", "a spreadsheet"}, Foreign{"walk", "id;time;x;y\n1;0;2;3\n", "a table of text"},
        Foreign{"walk.csv", "walk", "a table of text"}, Foreign{"utf16", "\xFF\xFE{", "a text in UTF-16"}),
    [](const auto& instance) { return as_test_name(instance.param.file); });

TEST(OtherFormats, AreNotToldByTheNameOfAFileThatHoldsGltf) {
  const TemporaryFolder folder;
  EXPECT_EQ(message_of(folder.write("really.fbx", editable_document().dump())), "");
}

TEST(OtherFormats, InJsonAreNoGltf) {
  const TemporaryFolder folder;
  EXPECT_THAT(message_of(folder.write("list.gltf", std::string("[1, 2]"))),
              HasSubstr("it is a list of JSON, not glTF"));
  EXPECT_THAT(message_of(folder.write("other.json", std::string(R"({"type": "FeatureCollection"})"))),
              ::testing::EndsWith("other.json: it is JSON, but not glTF, which says its version in \"asset\"; name a "
                                  ".glb or .gltf"));
}

TEST(OtherFormats, AreNotGuessedWhereNothingTellsThem) {
  const TemporaryFolder folder;
  EXPECT_THAT(message_of(folder.write("what", std::string("anything"))), HasSubstr("neither GLB nor valid JSON"));
}

}  // namespace
}  // namespace throng::import::testing::other_formats_test
