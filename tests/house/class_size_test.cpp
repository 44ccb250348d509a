#include "tests/house/class_size.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace throng::house::class_size_test {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using testing::StartsWith;

std::string methods(int count) {
  std::string text;
  for (int i = 0; i < count; ++i) text += "  int method" + std::to_string(i) + "(int a = f(1)) const { return {a}; }\n";
  return text;
}

Tree header(const std::string& inside, const std::string& path = "engine/anim/agent/crowd.h") {
  return {source_file(path, "class Crowd final : public Base {\n" + inside + "};\n")};
}

// The class has `more` public methods beside `most_public_methods` - 1.
Findings with_one_less_than_allowed_and(const std::string& more) {
  return classes_with_too_many_methods(header(" public:\n" + more + methods(most_public_methods - 1)));
}

TEST(ClassSize, MayBe30PublicMethods) {
  EXPECT_THAT(classes_with_too_many_methods(header(" public:\n" + methods(30))), IsEmpty());
  EXPECT_THAT(classes_with_too_many_methods(header(" public:\n" + methods(31))),
              ElementsAre(StartsWith("engine/anim/agent/crowd.h:1: Crowd has 31 public methods")));
}

TEST(ClassSize, CountsWhatIsPublicAlone) {
  EXPECT_THAT(classes_with_too_many_methods(header(methods(31))), IsEmpty());
  EXPECT_THAT(classes_with_too_many_methods(header(" public:\n" + methods(30) + " private:\n" + methods(5))),
              IsEmpty());
  EXPECT_THAT(classes_with_too_many_methods(header(methods(5) + " public:\n" + methods(31))), testing::SizeIs(1));
}

TEST(ClassSize, CountsEveryKindOfMethod) {
  for (const std::string method :
       {"virtual void step() = 0;", "explicit Crowd(int a);", "Crowd(int a) : a_{a}, b_(a) {}", "~Crowd() = default;",
        "bool operator==(const Crowd&) const = default;",
        "template <typename T>\n  T& as(Handle h) { return f<T>(h); }", "std::function<void(int)> visit() const;",
        "static int sum(int a);"}) {
    EXPECT_THAT(with_one_less_than_allowed_and(method + "\n"), IsEmpty()) << method;
    EXPECT_THAT(with_one_less_than_allowed_and(method + "\n" + method + "\n"), testing::SizeIs(1)) << method;
  }
}

TEST(ClassSize, CountsNothingElse) {
  EXPECT_THAT(
      with_one_less_than_allowed_and("  int a = f(2);\n  std::function<void(int)> visit;\n  // int b();\n"
                                     "  Crowd(const Crowd&) = delete;\n  int c{f(3)};\n  using F = int (*)(int);\n"
                                     "  struct Inside { int d(); int e(); };\n  enum class Kind { a, b };\n"
                                     "  friend bool same(const Crowd&);\n  static_assert(sizeof(int) == 4);\n"),
      IsEmpty());
}

TEST(ClassSize, LooksIntoStructsAndHeadersOfOursAlone) {
  const Tree plain{source_file("app/stage/stage.h", "struct Stage {\n" + methods(31) + "};\n")};
  EXPECT_THAT(classes_with_too_many_methods(plain), testing::SizeIs(1));
  EXPECT_THAT(classes_with_too_many_methods(header(" public:\n" + methods(31), "tests/anim/crowd.h")), IsEmpty());
}

}  // namespace
}  // namespace throng::house::class_size_test
