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

TEST(ClassSize, MayHave32PublicMethods) {
  EXPECT_THAT(classes_with_too_many_methods(header(" public:\n" + methods(32))), IsEmpty());
  EXPECT_THAT(classes_with_too_many_methods(header(" public:\n" + methods(33))),
              ElementsAre(StartsWith("engine/anim/agent/crowd.h:1: Crowd has 33 public methods")));
}

TEST(ClassSize, CountsWhatIsPublicAlone) {
  EXPECT_THAT(classes_with_too_many_methods(header(methods(33))), IsEmpty());
  EXPECT_THAT(classes_with_too_many_methods(header(" public:\n" + methods(32) + " private:\n" + methods(5))),
              IsEmpty());
  EXPECT_THAT(classes_with_too_many_methods(header(methods(5) + " public:\n" + methods(33))), testing::SizeIs(1));
}

TEST(ClassSize, CountsEveryKindOfMethod) {
  for (const std::string method :
       {"virtual void step() = 0;", "explicit Crowd(int a);", "Crowd(int a) : a_{a}, b_(a) {}", "~Crowd() = default;",
        "bool operator==(const Crowd&) const = default;",
        "template <typename T>\n  T& as(Handle h) { return f<T>(h); }", "std::function<void(int)> visit() const;",
        "static int sum(int a);", "friend bool same(const Crowd&);"}) {
    EXPECT_THAT(with_one_less_than_allowed_and(method + "\n"), IsEmpty()) << method;
    EXPECT_THAT(with_one_less_than_allowed_and(method + "\n" + method + "\n"), testing::SizeIs(1)) << method;
  }
}

TEST(ClassSize, CountsNothingElse) {
  EXPECT_THAT(
      with_one_less_than_allowed_and("  int a = f(2);\n  std::function<void(int)> visit;\n  // int b();\n"
                                     "  Crowd(const Crowd&) = delete;\n  int c{f(3)};\n  using F = int (*)(int);\n"
                                     "  struct Inside { int d(); int e(); };\n  enum class Kind { a, b };\n"
                                     "  friend class Rows;\n  static_assert(sizeof(int) == 4);\n"),
      IsEmpty());
}

TEST(ClassSize, CountsFriendFunctionsInAPrivatePartAsPublic) {
  const std::string friends = " private:\n  friend void move(Crowd& crowd) { crowd.x_ = 1; }\n";
  EXPECT_THAT(classes_with_too_many_methods(header(" public:\n" + methods(31) + friends)), IsEmpty());
  EXPECT_THAT(classes_with_too_many_methods(header(" public:\n" + methods(32) + friends)), testing::SizeIs(1));
  const std::string operators = "  friend bool operator==(const Crowd&, const Crowd&) = default;\n";
  EXPECT_THAT(classes_with_too_many_methods(header(" public:\n" + methods(32) + operators)), IsEmpty());
}

TEST(ClassSize, TellsPublicAndPrivateMethods) {
  const auto sizes = class_sizes(header(" public:\n" + methods(2) + " private:\n" + methods(3)));
  ASSERT_EQ(sizes.size(), 1U);
  EXPECT_EQ(sizes[0].public_methods, 2);
  EXPECT_EQ(sizes[0].private_methods, 3);
}

TEST(ClassSize, FindsFriendsThatAreMethods) {
  const auto friends_in = [](const std::string& text, const std::string& path) {
    return friends_that_are_methods(header(text, path));
  };
  const std::string move = "  friend void\n  move(Crowd& crowd);\n";
  EXPECT_THAT(friends_in(move, "app/people/crowd/crowd.h"), ElementsAre(StartsWith("app/people/crowd/crowd.h:2: ")));
  EXPECT_THAT(friends_in(move, "app/people/crowd/crowd.cpp"), testing::SizeIs(1));
  EXPECT_THAT(friends_in(move, "tests/crowd.h"), IsEmpty());
  EXPECT_THAT(friends_in("  friend class Rows;\n  friend bool operator==(const Crowd&, const Crowd&) = default;\n",
                         "app/people/crowd/crowd.h"),
              IsEmpty());
}

TEST(ClassSize, LooksIntoStructsAndHeadersOfOursAlone) {
  const Tree plain{source_file("app/show/stage/stage.h", "struct Stage {\n" + methods(33) + "};\n")};
  EXPECT_THAT(classes_with_too_many_methods(plain), testing::SizeIs(1));
  EXPECT_THAT(classes_with_too_many_methods(header(" public:\n" + methods(33), "tests/anim/crowd.h")), IsEmpty());
}

}  // namespace
}  // namespace throng::house::class_size_test
