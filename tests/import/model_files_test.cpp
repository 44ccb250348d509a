#include "engine/anim/import/model_files.h"

#include <filesystem>
#include <string>
#include <utility>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/import/test_files.h"

// A model in a folder of its own, and the names by which it asks for what lies beside it.

namespace throng::import::testing::model_files_test {
namespace {

namespace fs = std::filesystem;

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

class ModelBeside : public ::testing::Test {
 protected:
  /// Writes a model that names `uri` for its buffer.
  fs::path model(const std::string& uri, const std::string& name = "model.gltf") const {
    nlohmann::json document = editable_document();
    document["buffers"][0]["uri"] = uri;
    return folder_.write(name, document.dump());
  }

  void lay(const std::string& name) const { folder_.write(name, editable_buffer()); }

  TemporaryFolder folder_;
};

TEST_F(ModelBeside, FindsNamesWithEscapesAndDeeperFolders) {
  lay("parts/my model.bin");
  EXPECT_THAT(import_good(model("parts/my%20model.bin")).repairs, IsEmpty());
  EXPECT_THAT(import_good(model("./parts/my model.bin")).repairs, IsEmpty());
}

TEST_F(ModelBeside, FindsWhatOtherProgramsName) {
  lay("example 10%.bin");
  lay("my%20model.bin");
  lay("buffers/m.bin");
  for (const auto& [uri, oddity] : {std::pair("example 10%.bin", "percent sign that is no escape"),
                                    std::pair("example%2010%.bin", "percent sign that is no escape"),
                                    std::pair("my%20model.bin", "percent signs that are no escapes"),
                                    std::pair("buffers\\m.bin", "backslashes, taken as slashes"),
                                    std::pair("buffers/m.bin?v=3", "query or fragment, left out"),
                                    std::pair("buffers/m.bin#0", "query or fragment, left out"),
                                    std::pair("Buffers/M.BIN", "is found as \"buffers/m.bin\", whose letters")}) {
    const fs::path path = model(uri);
    EXPECT_THAT(import_good(path).repairs, ElementsAre(HasSubstr(oddity))) << uri;
    EXPECT_THAT(message_of(path, true), HasSubstr(oddity)) << uri << ", strictly";
  }
}

TEST_F(ModelBeside, TakesTheExactNameBeforeAnyOther) {
  lay("a b.bin");
  folder_.write("a%20b.bin", std::string("too short"));
  folder_.write("A b.bin", std::string("too short"));
  EXPECT_THAT(import_good(model("a%20b.bin")).repairs, IsEmpty());
}

TEST_F(ModelBeside, GuessesNoCaseAmongSeveral) {
  lay("m.bin");
  lay("M.bin");
  EXPECT_THAT(message_of(model("m.BIN")), HasSubstr("there is no file \"m.BIN\""));
}

TEST_F(ModelBeside, NamesTheFileThatIsMissing) {
  EXPECT_THAT(message_of(model("parts/body.bin")),
              HasSubstr("buffer 0: there is no file \"parts/body.bin\" beside the model; copy it there"));
  fs::create_directory(model("parts").parent_path() / "parts");
  EXPECT_THAT(message_of(model("parts")), HasSubstr("\"parts\" names a folder"));
}

TEST_F(ModelBeside, OpensWhatALinkInTheFolderLeadsToUnlessStrict) {
  const TemporaryFolder blobs;
  const fs::path blob = blobs.write("ab12cd", editable_buffer());
  const fs::path path = model("m.bin");
  fs::create_symlink(blob, path.parent_path() / "m.bin");
  EXPECT_THAT(import_good(path).repairs, IsEmpty());
  EXPECT_THAT(message_of(path, true), HasSubstr("leaves the model's folder by a link"));
  fs::remove(blob);
  EXPECT_THAT(message_of(path), HasSubstr("is a link that leads nowhere"));
}

TEST_F(ModelBeside, OpensALinkThatStaysInTheFolderStrictlyToo) {
  lay("blobs/ab12cd");
  const fs::path path = model("m.bin");
  fs::create_symlink("blobs/ab12cd", path.parent_path() / "m.bin");
  EXPECT_EQ(message_of(path, true), "");
}

TEST_F(ModelBeside, IsFoundWhereTheModelsOwnLinkLeads) {
  lay("m.bin");
  const fs::path path = model("m.bin");
  const TemporaryFolder desktop;
  const fs::path link = desktop.write("x", std::string()).parent_path() / "model.gltf";
  fs::create_symlink(path, link);
  EXPECT_THAT(import_good(link).repairs, IsEmpty());
  EXPECT_THAT(message_of(link, true), HasSubstr("there is no file \"m.bin\""));
}

TEST_F(ModelBeside, NeverLeavesTheFolderByItsName) {
  const TemporaryFolder outside;
  const fs::path secret = outside.write("secret.bin", editable_buffer());
  const std::string up = "../" + secret.parent_path().filename().string() + "/secret.bin";
  std::string escaped = up, windows = up;
  escaped.replace(0, 3, "%2e%2e%2F");
  windows.replace(2, 1, "\\");
  for (const std::string& uri : {up, escaped, windows, "parts/../" + up}) {
    EXPECT_THAT(message_of(model(uri)), HasSubstr("leaves the model's folder")) << uri;
  }
  for (const std::string& uri : {secret.string(), "file://" + secret.string(), std::string("C:\\body.bin"),
                                 std::string("%2Fetc/passwd"), std::string("\\\\host\\share\\m.bin")}) {
    EXPECT_THAT(message_of(model(uri)), HasSubstr("is no relative path; put that file beside the model")) << uri;
  }
  EXPECT_THAT(message_of(model("https://example.org/m.bin")), HasSubstr("is a web address; download that file"));
}

TEST_F(ModelBeside, ReadsDataUrisOfAnyCaseAndForm) {
  const std::string uri = editable_document()["buffers"][0]["uri"];
  const std::string data = uri.substr(uri.find(','));
  EXPECT_THAT(import_good(model("DATA:application/octet-stream;BASE64" + data)).repairs, IsEmpty());
  std::string percent = "data:application/octet-stream,";
  for (const char byte : editable_buffer()) {
    constexpr const char* digits = "0123456789abcdef";
    const auto bits = static_cast<unsigned char>(byte);
    percent.append({'%', digits[bits >> 4U], digits[bits & 15U]});
  }
  EXPECT_THAT(import_good(model(percent)).repairs, IsEmpty());
}

TEST_F(ModelBeside, ShowsItsShapeWithoutAnImageThatIsMissing) {
  nlohmann::json document = editable_document();
  document["images"] = {{{"uri", "skin colour.png"}}};
  document["textures"] = {{{"source", 0}}};
  document["materials"] = {{{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}}}};
  document["meshes"][0]["primitives"][0]["material"] = 0;
  const anim::ImportedFile file = import_good(folder_.write("model.gltf", document.dump()));
  EXPECT_THAT(file.repairs, ElementsAre(HasSubstr("image 0: left out, because there is no file \"skin colour.png\"")));
  EXPECT_FALSE(file.models.front().meshes.empty());
}

}  // namespace
}  // namespace throng::import::testing::model_files_test
