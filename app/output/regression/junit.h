#pragma once

#include <string>

#include "app/output/regression/outcome.h"

namespace throng::app {

/// Returns a run as JUnit XML, which every server for continuous integration reads: a test case for each picture, in a
/// class for each context.
std::string junit_xml(const RegressionRun& run);

}  // namespace throng::app
