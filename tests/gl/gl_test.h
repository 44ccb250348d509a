#pragma once

#include <memory>

#include <gtest/gtest.h>

#include "throng/render/context.h"

namespace throng::render::test {

/// A test with a context on the software device. It fails if the driver sends a message.
class SoftwareGlTest : public testing::Test {
 protected:
  void SetUp() override {
    Result<std::unique_ptr<gl::Context>> context = gl::make_egl_context({.force_software = true});
    ASSERT_TRUE(context) << context.error().message;
    context_ = std::move(*context);
    ASSERT_TRUE(context_->is_software()) << context_->renderer();
  }

  void TearDown() override {
    if (context_ == nullptr) return;
    for (const std::string& message : context_->messages().messages()) ADD_FAILURE() << message;
  }

  gl::Context& context() { return *context_; }

 private:
  std::unique_ptr<gl::Context> context_;
};

}  // namespace throng::render::test
