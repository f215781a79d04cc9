#include "ir/words/post_forms.h"

#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace arelem {
namespace {

TEST(PostForms, EachWordIsOfThePostprocessorAndStandsOnce) {
  std::set<Word> seen;
  for (const PostForm& form : postForms()) {
    const WordClass c = row(form.word).wordClass;
    EXPECT_TRUE(c == WordClass::postWithParameters || c == WordClass::postWithoutParameters ||
                c == WordClass::transformation)
        << spell(form.word);
    EXPECT_TRUE(seen.insert(form.word).second) << spell(form.word);
    EXPECT_LE(form.least, form.most) << spell(form.word);
    EXPECT_EQ(form.pattern.empty(), form.most == 0 && form.words.empty()) << spell(form.word);
    EXPECT_FALSE(form.meaning.empty()) << spell(form.word);
  }
}

TEST(PostForms, EveryWordWithParametersHasARow) {
  for (std::size_t i = 0; i < static_cast<std::size_t>(Word::count); ++i) {
    const auto word = static_cast<Word>(i);
    if (row(word).wordClass == WordClass::postWithParameters) {
      EXPECT_NE(postForm(word), nullptr) << spell(word);
    }
  }
}

TEST(PostForms, TakesWholeWordsOfTheList) {
  const PostForm& spindle = *postForm(Word::SPINDL);
  EXPECT_TRUE(spindle.takes("ON"));
  EXPECT_TRUE(spindle.takes("ORIENT"));
  EXPECT_FALSE(spindle.takes("FLOOD"));
  EXPECT_FALSE(spindle.takes("O"));
  EXPECT_FALSE(spindle.takes("CLW CCLW"));
  EXPECT_FALSE(spindle.takes(""));
  EXPECT_TRUE(postForm(Word::CYCLE)->takes("1STPECK"));
  EXPECT_EQ(postForm(Word::ZERO), nullptr);
}

}  // namespace
}  // namespace arelem
