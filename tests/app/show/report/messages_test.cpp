#include "app/show/report/messages.h"

#include <string>

#include <gtest/gtest.h>

namespace throng::app::messages_test {
namespace {

TEST(Messages, FadeAndAreKept) {
  Messages messages;
  messages.say("Wrote throng-1.png");
  EXPECT_EQ(messages.presence(messages.all().front()), 1.0F);
  messages.pass(60.0);
  EXPECT_EQ(messages.presence(messages.all().front()), 0.0F);
  ASSERT_EQ(messages.all().size(), 1U);
  EXPECT_EQ(messages.age(messages.all().front()), 60.0);
}

TEST(Messages, AreSeenTheLongerTheMoreWordsTheyHave) {
  Messages messages;
  messages.say("Short.");
  messages.say(std::string(200, 'x'));
  messages.pass(6.0);
  EXPECT_EQ(messages.presence(messages.all().front()), 0.0F);
  EXPECT_EQ(messages.presence(messages.all().back()), 1.0F);
}

TEST(Messages, OneThatIsSaidInEachFrameFillsNoLog) {
  Messages messages;
  for (int frame = 0; frame < 100; ++frame) {
    EXPECT_FALSE(messages.report(Error{"the disk is full"}));
    messages.pass(1.0 / 60.0);
  }
  ASSERT_EQ(messages.all().size(), 1U);
  EXPECT_EQ(messages.all().front().kind, Message::Kind::refused);
  EXPECT_LT(messages.age(messages.all().front()), 0.1) << "it is said until it ends";
}

TEST(Messages, OfSuccessAndFailureAreToldApart) {
  Messages messages;
  messages.report(Done{}, "Wrote it");
  messages.report(Error{"a.glb: cannot be read"}, "Read it");
  ASSERT_EQ(messages.all().size(), 2U);
  EXPECT_EQ(messages.all()[0].words, "Wrote it");
  EXPECT_EQ(messages.all()[1].words, "a.glb: cannot be read");
}

TEST(Messages, TheOldestGoFirst) {
  Messages messages;
  for (std::size_t i = 0; i < Messages::most_messages + 10; ++i) messages.say(std::to_string(i));
  EXPECT_EQ(messages.all().size(), Messages::most_messages);
  EXPECT_EQ(messages.all().front().words, "10");
}

}  // namespace
}  // namespace throng::app::messages_test
