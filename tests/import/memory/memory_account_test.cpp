#include "engine/anim/import/memory/memory_account.h"

#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "engine/anim/import/memory/json_memory.h"

namespace throng::import::testing::memory_account_test {
namespace {

using ::testing::HasSubstr;

TEST(MemoryAccount, AllowsFourTimesTheFilesAndSixtyFourMegabytes) {
  MemoryAccount account;
  account.add_file(1'000'000, "the file");
  account.add_file(500'000, "buffer 0");
  EXPECT_EQ(account.left(), 64'000'000U + 4 * 1'500'000 - 1'500'000);
}

TEST(MemoryAccount, RefusesOneByteTooManyByTheNameOfTheObject) {
  MemoryAccount account(1000);
  account.charge(400, "mesh 0");
  account.charge(600, "mesh 1");
  try {
    account.charge(1, "mesh 2");
    FAIL();
  } catch (const MemoryRefusal& refusal) {
    EXPECT_STREQ(refusal.what(),
                 "mesh 2 needs 1 bytes of memory, and 0 bytes are left of the 1000 bytes that the import may take; "
                 "use smaller images or meshes, or allow more with --memory-limit");
  }
  EXPECT_EQ(account.left(), 0U) << "what was refused is not held";
}

TEST(MemoryAccount, TellsLargeSizesInMegabytes) {
  try {
    MemoryAccount().charge(268'435'456, "image 0");
    FAIL();
  } catch (const MemoryRefusal& refusal) {
    EXPECT_THAT(refusal.what(), HasSubstr("needs 268.4 MB of memory, and 64.0 MB are left of the 64.0 MB"));
  }
}

TEST(MemoryAccount, KnowsNoSizeThatIsTooLargeToAdd) {
  MemoryAccount account;
  account.charge(1, "mesh 0");
  EXPECT_THROW(account.charge(~std::uint64_t{0}, "mesh 1"), MemoryRefusal);
  EXPECT_THROW(account.add_file(~std::uint64_t{0}, "buffer 0"), MemoryRefusal);
}

TEST(MemoryAccount, GivesImagesAnAllowanceThatEnds) {
  MemoryAccount account;
  EXPECT_EQ(account.take_image_allowance(1000), 128'000U);
  EXPECT_EQ(account.take_image_allowance(1'000'000'000), 1'000'000'000U - 128'000U);
  EXPECT_EQ(account.take_image_allowance(1000), 0U);
  account.give_back_image_allowance(100);
  EXPECT_EQ(account.take_image_allowance(1000), 100U);
}

TEST(MemoryAccount, OfAGivenLimitHasNoAllowance) {
  MemoryAccount account(1'000'000);
  account.add_file(1000, "the file");
  EXPECT_EQ(account.left(), 999'000U);
  EXPECT_EQ(account.take_image_allowance(1000), 0U);
  EXPECT_EQ(account.json_allowance(1000), 0U);
}

TEST(MemoryScope, GivesBackAllButWhatIsKept) {
  MemoryAccount account(1000);
  {
    MemoryScope outer(account);
    account.charge(100, "a");
    {
      MemoryScope inner(account);
      account.charge(200, "b");
      inner.keep(50);
    }
    EXPECT_EQ(account.held(), 150U);
    account.charge_for_good(30, "an image");
    outer.keep(10);
  }
  EXPECT_EQ(account.held(), 10U);
  EXPECT_EQ(account.left(), 960U) << "an image stays whatever scope it was read in";
}

TEST(JsonMemory, CountsWhatStandsOutsideOfTexts) {
  EXPECT_EQ(parsed_json_memory(R"("{[,:")"), parsed_json_memory(R"("abcd")"));
  EXPECT_GT(parsed_json_memory("[{},{}]"), parsed_json_memory("[{}]") + 64);
  EXPECT_GT(parsed_json_memory(R"("\"{{{{{{{{{{")"), 0U);
}

}  // namespace
}  // namespace throng::import::testing::memory_account_test
