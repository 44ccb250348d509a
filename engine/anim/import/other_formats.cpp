#include "engine/anim/import/other_formats.h"

#include <algorithm>
#include <array>
#include <string_view>

#include "engine/anim/import/bytes/data_uri.h"

namespace throng::import {

namespace {

using namespace std::string_view_literals;

constexpr std::string_view by_blender = "import it in Blender and export glTF 2.0 (.glb)";
constexpr std::string_view by_its_program = "export it as glTF 2.0 (.glb) from the program that made it";
constexpr std::string_view by_fbx = "export it from its program as FBX, import that in Blender, and export glTF 2.0";
constexpr std::string_view by_unpacking = "unpack it and open the .glb or .gltf in it";
constexpr std::string_view by_opening = "open it in Blender and export glTF 2.0 (.glb)";
constexpr std::string_view by_table =
    "if its rows say who is where when, save them as CSV and give it with --trajectories";
constexpr std::string_view by_model = "open the .glb or .gltf file that it belongs to";

struct Format {
  std::string_view what;
  std::string_view remedy;
};

constexpr Format fbx{"an FBX file", by_blender};
constexpr Format usd{"a USD file", by_blender};
constexpr Format usdz{"a USDZ file, which holds USD", "import it in Blender and export glTF 2.0 (.glb)"};
constexpr Format dae{"a COLLADA file", by_blender};
constexpr Format obj{"a Wavefront OBJ file, which has no skeleton", "export the rigged character as glTF 2.0 (.glb)"};
constexpr Format bvh{"a BVH motion file", "import it in Blender, give it a skinned mesh and export glTF 2.0 (.glb)"};
constexpr Format blend{"a Blender file", by_opening};
constexpr Format max{"a 3ds Max file", by_its_program};
constexpr Format maya{"a Maya file", by_fbx};
constexpr Format cinema{"a Cinema 4D file", by_its_program};
constexpr Format ply{"a PLY file, which has no skeleton", "export the rigged character as glTF 2.0 (.glb)"};
constexpr Format stl{"an STL file, which has no skeleton", "export the rigged character as glTF 2.0 (.glb)"};
constexpr Format studio{"a 3DS file", by_blender};
constexpr Format direct_x{"a DirectX .x file", by_fbx};
constexpr Format alembic{"an Alembic cache, which has no skeleton", "export the rigged character as glTF 2.0 (.glb)"};
constexpr Format mmd{"an MMD file", "import it in Blender by an MMD add-on and export glTF 2.0 (.glb)"};
constexpr Format source_model{"a Source engine model", "import it in Blender by an add-on and export glTF 2.0 (.glb)"};
constexpr Format doom{"an id Software model", "import it in Blender by an add-on and export glTF 2.0 (.glb)"};
constexpr Format unreal{"an Unreal Engine asset", "export it there as glTF 2.0 (.glb)"};
constexpr Format unity{"a Unity package", "export the character there as glTF 2.0 (.glb) or FBX"};
constexpr Format archive{"an archive", by_unpacking};
constexpr Format tiles{"a 3D Tiles file", "open the .glb that it wraps"};
constexpr Format draco{"a bare Draco mesh", "export the rigged character as glTF 2.0 (.glb)"};
constexpr Format picture{"a picture", by_model};
constexpr Format buffer{"a buffer of a .gltf file", by_model};
constexpr Format web_page{"a web page, so a download probably failed", "download the file again"};
constexpr Format hdf5{"an HDF5 file", by_table};
constexpr Format parquet{"a Parquet table", by_table};
constexpr Format arrow{"an Arrow table", by_table};
constexpr Format numpy{"an array of NumPy", by_table};
constexpr Format matlab{"a MATLAB file", by_table};
constexpr Format sqlite{"a database of SQLite", "if it is a recorded crowd, give it with --trajectories"};
constexpr Format spreadsheet{"a spreadsheet", by_table};
constexpr Format text_table{"a table of text", "if its rows say who is where when, give it with --trajectories"};
constexpr Format wide_text{"a text in UTF-16", "save it as UTF-8"};
constexpr Format json_list{"a list of JSON", "name a .glb or .gltf"};
constexpr Format pdf{"a PDF", by_model};
constexpr Format recording{"a recording", "give it with --replay"};

/// How a file of a format begins, or its name ends.
struct Mark {
  std::string_view text;
  Format format;
};

constexpr auto signatures = std::to_array<Mark>({{"Kaydara FBX Binary", fbx},
                                                 {"; FBX ", fbx},
                                                 {"PXR-USDC", usd},
                                                 {"#usda", usd},
                                                 {"HIERARCHY", bvh},
                                                 {"BLENDER", blend},
                                                 {"//Maya ASCII", maya},
                                                 {"FOR4", maya},
                                                 {"FOR8", maya},
                                                 {"QC4DC4D", cinema},
                                                 {"ply\n", ply},
                                                 {"ply\r", ply},
                                                 {"xof 0", direct_x},
                                                 {"Ogawa", alembic},
                                                 {"PMX ", mmd},
                                                 {"Pmd", mmd},
                                                 {"Vocaloid Motion Data", mmd},
                                                 {"IDST", source_model},
                                                 {"IDP2", doom},
                                                 {"IDP3", doom},
                                                 {"MD5Version", doom},
                                                 {"INTERQUAKEMODEL", doom},
                                                 {"\xC1\x83\x2A\x9E", unreal},
                                                 {"b3dm", tiles},
                                                 {"i3dm", tiles},
                                                 {"DRACO", draco},
                                                 {"\x89PNG", picture},
                                                 {"\xFF\xD8\xFF", picture},
                                                 {"RIFF", picture},
                                                 {"\xABKTX", picture},
                                                 {"7z\xBC\xAF", archive},
                                                 {"Rar!", archive},
                                                 {"\xFD"
                                                  "7zXZ",
                                                  archive},
                                                 {"THRONGRC", recording},
                                                 {"\x89HDF\r\n\x1A\n", hdf5},
                                                 {"PAR1", parquet},
                                                 {"ARROW1", arrow},
                                                 {"\x93NUMPY", numpy},
                                                 {"MATLAB 5.0 MAT-file", matlab},
                                                 {"SQLite format 3\0"sv, sqlite},
                                                 {"%PDF-", pdf},
                                                 {"\xFF\xFE", wide_text},
                                                 {"\xFE\xFF", wide_text}});

/// Many formats share a container, so the name's ending goes before these.
constexpr auto containers =
    std::to_array<Mark>({{"PK\x03\x04", archive}, {"\x1F\x8B", archive}, {"\x28\xB5\x2F\xFD", archive}});

constexpr auto endings = std::to_array<Mark>({{".fbx", fbx},          {".usd", usd},
                                              {".usda", usd},         {".usdc", usd},
                                              {".usdz", usdz},        {".dae", dae},
                                              {".obj", obj},          {".bvh", bvh},
                                              {".blend", blend},      {".max", max},
                                              {".ma", maya},          {".mb", maya},
                                              {".c4d", cinema},       {".ply", ply},
                                              {".stl", stl},          {".3ds", studio},
                                              {".x", direct_x},       {".abc", alembic},
                                              {".pmx", mmd},          {".pmd", mmd},
                                              {".vmd", mmd},          {".smd", source_model},
                                              {".mdl", source_model}, {".md5mesh", doom},
                                              {".uasset", unreal},    {".unitypackage", unity},
                                              {".zip", archive},      {".7z", archive},
                                              {".rar", archive},      {".gz", archive},
                                              {".drc", draco},        {".png", picture},
                                              {".jpg", picture},      {".jpeg", picture},
                                              {".webp", picture},     {".ktx2", picture},
                                              {".bin", buffer},       {".rec", recording},
                                              {".csv", text_table},   {".tsv", text_table},
                                              {".xlsx", spreadsheet}, {".xls", spreadsheet},
                                              {".ods", spreadsheet}});

std::string sentence(const Format& format) {
  return "it is " + std::string(format.what) + ", not glTF; " + std::string(format.remedy);
}

const Format* by_ending(const std::filesystem::path& path) {
  const std::string ending = path.extension().string();
  const auto found =
      std::ranges::find_if(endings, [&](const Mark& each) { return equal_without_case(each.text, ending); });
  return found == endings.end() ? nullptr : &found->format;
}

const Format* by_beginning(std::span<const Mark> known, std::string_view text) {
  const auto found = std::ranges::find_if(known, [&](const Mark& each) { return text.starts_with(each.text); });
  return found == known.end() ? nullptr : &found->format;
}

/// COLLADA and web pages begin as any other XML.
const Format* by_markup(std::string_view text) {
  const std::string_view head = text.substr(0, 4096);
  if (!head.starts_with('<')) return nullptr;
  if (head.find("<COLLADA") != std::string_view::npos) return &dae;
  for (const std::string_view tag : {"<html", "<HTML", "<!doctype html", "<!DOCTYPE html"}) {
    if (head.find(tag) != std::string_view::npos) return &web_page;
  }
  return nullptr;
}

/// A first line of words or numbers with separators between them begins a table, or a .gltf that is damaged.
const Format* by_first_line(std::string_view text, const std::filesystem::path& path) {
  if (text.starts_with('[')) return &json_list;
  if (equal_without_case(path.extension().string(), ".gltf")) return nullptr;
  const std::string_view line = text.substr(0, std::min(text.find_first_of("\r\n"), std::size_t{4096}));
  const bool is_plain =
      std::ranges::all_of(line, [](char c) { return c == '\t' || static_cast<unsigned char>(c) >= ' '; });
  return is_plain && line.find_first_of(",;\t") != std::string_view::npos ? &text_table : nullptr;
}

}  // namespace

std::string describe_other_format(std::span<const std::byte> bytes, const std::filesystem::path& path) {
  std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  if (const Format* format = by_beginning(signatures, text)) return sentence(*format);
  if (const Format* format = by_ending(path)) return sentence(*format);
  if (const Format* format = by_beginning(containers, text)) return sentence(*format);
  const std::size_t begin = text.find_first_not_of("\xEF\xBB\xBF \t\r\n");
  text.remove_prefix(std::min(begin, text.size()));
  const Format* format = by_markup(text);
  if (format == nullptr) format = by_first_line(text, path);
  return format == nullptr ? std::string() : sentence(*format);
}

}  // namespace throng::import
