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
                 "use smaller images or meshes, or a larger memory limit (--memory-limit, LoadOptions::memory_limit)");
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

TEST(MemoryAccount, GivesEachImageItsShareHoweverSmallItsFileIs) {
  MemoryAccount account;
  EXPECT_EQ(account.image_share(0, 4), 250'000'000U);
  account.charge_for_image(100'000'000, "image 0");
  EXPECT_EQ(account.image_share(0, 3), 300'000'000U);
  EXPECT_EQ(account.image_share(1000, 3), 300'002'000U) << "a large file may have a large image";
  EXPECT_EQ(account.left(), 64'000'000U) << "meshes lose nothing to images";
}

TEST(MemoryAccount, KeepsSmallImagesWholeBesideMany) { EXPECT_EQ(MemoryAccount().image_share(0, 100'000), 4U << 20U); }

TEST(MemoryAccount, RefusesImagesThatTookTooMuchToDecode) {
  MemoryAccount account;
  for (int i = 0; i < 5; ++i) account.count_decoded(1'000'000'000, "image");
  try {
    account.count_decoded(1, "image 5");
    FAIL();
  } catch (const MemoryRefusal& refusal) {
    EXPECT_THAT(refusal.what(), HasSubstr("image 5 is one too many: the images before it have 5000.0 MB of pixels; "));
  }
}

TEST(MemoryAccount, OfAGivenLimitHasNoAllowance) {
  MemoryAccount account(1'000'000);
  account.add_file(1000, "the file");
  EXPECT_EQ(account.left(), 999'000U);
  EXPECT_EQ(account.image_share(1000, 3), 999'000U);
  EXPECT_EQ(account.decoder_memory(), 999'000U);
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
