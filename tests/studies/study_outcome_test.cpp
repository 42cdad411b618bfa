// SPDX-License-Identifier: Apache-2.0
#include <catch2/catch.hpp>

#include <twum/base/error.hpp>
#include <twum/studies/study_outcome.hpp>

#include <set>
#include <string>

using namespace twum;
using namespace twum::studies;

TEST_CASE("every outcome has a word of its own, which leads back to it", "[studies]") {
  std::set<std::string> words;
  for (int i = 0; i <= static_cast<int>(StudyOutcome::done); ++i) {
    const auto outcome = static_cast<StudyOutcome>(i);
    const OutcomeWord word = outcome;
    CHECK(word == to_string(outcome));
    CHECK(OutcomeWord(word.c_str()) == outcome);
    CHECK(std::string(word) == word.c_str());
    words.insert(word);
  }
  CHECK(words.size() == static_cast<std::size_t>(StudyOutcome::done) + 1);
  CHECK_THROWS_AS(OutcomeWord("perfect"), InputError);
}

TEST_CASE("the outcome of a search keeps its word", "[studies]") {
  for (const optim::Outcome search :
       {optim::Outcome::optimal, optim::Outcome::feasible, optim::Outcome::infeasible,
        optim::Outcome::budget, optim::Outcome::failed})
    CHECK(std::string(to_string(outcome_of(search))) == optim::to_string(search));
}
