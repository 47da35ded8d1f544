#include "problems/table_reader.hpp"

#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>

#include "core/error.hpp"
#include "core/evaluate.hpp"

namespace rfm {
namespace {

std::string mistake_in(const std::string& text) {
  try {
    parse_table(text, "f.csv");
  } catch (const InputError& mistake) {
    return mistake.what();
  }
  return "none";
}

TEST(ParseTable, TakesColumnsSeparatedAsSpreadsheetsDo) {
  for (const char* text :
       {"0,1\n0.5,-2e-3\n", "0 1\r\n0.5 -2e-3\r\n", "0;1\n0.5;-2e-3", "\t0\t1\n\n  0.5  -2e-3\n",
        "time, load\n0, 1\n# a comment\n+0.5, -.002\n",
        "\xEF\xBB\xBF"
        "0,1\n0.5,-0.002\n"}) {
    const TablePoints points = parse_table(text, "f.csv");
    EXPECT_THAT(points.abscissae, testing::ElementsAre(0, 0.5)) << text;
    EXPECT_THAT(points.values, testing::ElementsAre(1, -2e-3)) << text;
  }
}

TEST(ParseTable, NamesTheLineOfAMistake) {
  EXPECT_EQ(mistake_in("0 1\n1 two\n"), "f.csv:2: expected a number but found 'two'");
  EXPECT_EQ(mistake_in("0 1\n\n1\n"), "f.csv:3: expected two numbers but found 1 entry");
  EXPECT_EQ(mistake_in("0 1 2\n"), "f.csv:1: expected two numbers but found 3 entries");
  EXPECT_EQ(mistake_in("x y\nx y\n"), "f.csv:2: expected a number but found 'x'");
  EXPECT_EQ(mistake_in("0 1\n1 nan\n"), "f.csv:2: expected a number but found 'nan'");
  EXPECT_EQ(mistake_in("0 1\n1 1e999\n"), "f.csv:2: expected a number but found '1e999'");
  EXPECT_EQ(mistake_in("0 1\n1 1e-999\n"), "f.csv:2: expected a number but found '1e-999'");
  // Not a line of titles.
  EXPECT_EQ(mistake_in("1e-999 1\n1 2\n2 3\n"), "f.csv:1: expected a number but found '1e-999'");
  EXPECT_EQ(
      mistake_in("0 1\n1 2\n1 3\n"),
      "f.csv:3: the first column must ascend, but '1' is not larger than the number above it");
  EXPECT_EQ(mistake_in("0 1\n"), "f.csv: a table needs at least two lines of two numbers");
  EXPECT_EQ(mistake_in(""), "f.csv: a table needs at least two lines of two numbers");
}

class TableFunction : public testing::Test {
 protected:
  TableFunction() {
    folder_ = std::filesystem::temp_directory_path() /
              ("rfm_table_" + std::to_string(reinterpret_cast<std::uintptr_t>(this)));
    std::filesystem::create_directory(folder_);
    std::ofstream(folder_ / "square.csv") << "-1 1\n0 0\n1 1\n2 4\n";
    scope_ = coordinate_scope(2);
    scope_.define_function("table", table_function(folder_.string()));
  }
  ~TableFunction() override { std::filesystem::remove_all(folder_); }

  Field read(const std::string& text) const { return to_field(Expression(text), scope_); }
  std::string mistake(const std::string& text) const {
    try {
      read(text);
    } catch (const InputError& error) {
      return std::to_string(error.offset) + "+" + std::to_string(error.length) + ": " +
             error.what();
    }
    return "none";
  }

  std::filesystem::path folder_;
  ExpressionScope scope_;
};

TEST_F(TableFunction, IsAFieldOfItsArgument) {
  EXPECT_NEAR(value_at(read("1 + table('square.csv', x)"), {1.5, 7}), 3.25, 1e-15);
  EXPECT_NEAR(value_at(read("table(\"square.csv\", y)^2"), {7, 1.5}), 5.0625, 1e-14);
}

TEST_F(TableFunction, OfANumberIsANumber) {
  EXPECT_NEAR(read("table('square.csv', 3/2)").constant(), 2.25, 1e-15);
  EXPECT_EQ(mistake("table('square.csv', 3)"),
            "20+1: 3 lies outside the table, which goes from -1 to 2");
}

TEST_F(TableFunction, MistakesHaveTheirPlace) {
  EXPECT_EQ(mistake("2*table('none.csv', x)"),
            "8+10: cannot read the file 'none.csv' beside the problem file");
  EXPECT_EQ(mistake("table('../square.csv', x)"),
            "6+15: the file of a table must lie in the folder of the problem file");
  EXPECT_EQ(mistake("table('/etc/passwd', x)"),
            "6+13: the file of a table must lie in the folder of the problem file");
  EXPECT_EQ(mistake("table(x, x)"), "6+1: expected a text in quotes");
  EXPECT_EQ(mistake("table('square.csv')"), "0+5: table takes 2 arguments, got 1");
  EXPECT_EQ(mistake("table('square.csv', 'x')"), "20+3: a quoted text is not a number");
  EXPECT_EQ(mistake("table('square.csv', q)"), "20+1: unknown name 'q'");
}

}  // namespace
}  // namespace rfm
