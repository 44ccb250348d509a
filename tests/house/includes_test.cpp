#include "tests/house/includes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace throng::house::includes_test {
namespace {

using testing::ElementsAre;
using testing::Pair;

TEST(OwnHeaders, AreCountedOnceThroughAllThatHeadersInclude) {
  const Tree tree{source_file("app/a.cpp", "#include \"app/a.h\"\n#include \"app/b.h\"\n#include <vector>\n"),
                  source_file("app/a.h", "#include \"app/b.h\"\n#include \"throng/ids.h\"\n"),
                  source_file("app/b.h", "#include \"engine/c.h\"\n"), source_file("engine/c.h", ""),
                  source_file("engine/anim/include/throng/ids.h", "")};
  EXPECT_THAT(own_headers_behind(tree), ElementsAre(Pair("app/a.cpp", 4)));
}

}  // namespace
}  // namespace throng::house::includes_test
