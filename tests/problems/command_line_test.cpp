#include "problems/command_line.hpp"

#include <gmock/gmock.h>

using namespace rfm;
using Command = CommandLine::Command;
using testing::ElementsAre;
using testing::HasSubstr;

TEST(CommandLine, SolvesTheFilesItNames) {
  const CommandLine line = parse_command_line({"a.yaml", "b.yaml"});
  EXPECT_EQ(line.command, Command::solve);
  EXPECT_THAT(line.files, ElementsAre("a.yaml", "b.yaml"));
  EXPECT_EQ(line.converge, 1);
  EXPECT_TRUE(line.verify);
  EXPECT_FALSE(line.picture || line.quiet || line.json || line.threads || line.output);
}
TEST(CommandLine, TakesOptionsInAnyOrder) {
  const CommandLine line = parse_command_line({"--set", "a.b=[1, 2]", "f.yaml", "--set", "c=x == y",
                                               "--output", "out", "--threads", "3", "--converge=4",
                                               "--picture", "--quiet", "--json", "--no-verify"});
  EXPECT_EQ(line.command, Command::solve);
  EXPECT_THAT(line.files, ElementsAre("f.yaml"));
  EXPECT_THAT(line.overrides, ElementsAre("a.b=[1, 2]", "c=x == y"));
  EXPECT_EQ(line.output, "out");
  EXPECT_EQ(line.threads, 3);
  EXPECT_EQ(line.converge, 4);
  EXPECT_TRUE(line.picture && line.quiet && line.json);
  EXPECT_FALSE(line.verify);
}
TEST(CommandLine, KnowsItsCommands) {
  const CommandLine check =
      parse_command_line({"check", "f.yaml", "--set", "a=1", "--picture", "--output", "out"});
  EXPECT_EQ(check.command, Command::check);
  EXPECT_TRUE(check.picture);
  EXPECT_EQ(check.output, "out");
  EXPECT_THAT(check.files, ElementsAre("f.yaml"));
  EXPECT_THAT(check.overrides, ElementsAre("a=1"));
  EXPECT_EQ(parse_command_line({"explain", "conditions.flux"}).key, "conditions.flux");
  EXPECT_EQ(parse_command_line({"schema"}).command, Command::schema);
}
TEST(CommandLine, PrintsHelpAndVersion) {
  const CommandLine help = parse_command_line({"--help"});
  EXPECT_EQ(help.command, Command::print);
  EXPECT_EQ(help.exit_status, 0);
  for (const char* word : {"--set", "--output", "--threads", "--converge", "--picture", "--quiet",
                           "--json", "--no-verify", "check", "explain", "schema", "--version"})
    EXPECT_THAT(help.text, HasSubstr(word));
  const CommandLine version = parse_command_line({"--version"});
  EXPECT_THAT(version.text, testing::MatchesRegex("rfm-solve [0-9]+.[0-9]+.[0-9]+\n"));
  EXPECT_EQ(version.exit_status, 0);
}
TEST(CommandLine, RefusesWhatItDoesNotKnow) {
  const auto refusal = [](std::vector<std::string> arguments) {
    const CommandLine line = parse_command_line(std::move(arguments));
    EXPECT_EQ(line.command, Command::print);
    EXPECT_EQ(line.exit_status, 2);
    return line.text.substr(0, line.text.find('\n'));
  };
  EXPECT_EQ(refusal({}), "expected a problem file");
  EXPECT_EQ(refusal({"check"}), "expected a problem file");
  EXPECT_EQ(refusal({"f.yaml", "--ouput", "x"}),
            "unexpected argument '--ouput' (did you mean '--output'?)");
  EXPECT_EQ(refusal({"new", "plate"}), "'new' is not supported yet");
  EXPECT_THAT(refusal({"explain"}), HasSubstr("KEY"));
  EXPECT_THAT(refusal({"f.yaml", "--threads", "0"}), HasSubstr("--threads"));
  EXPECT_THAT(refusal({"f.yaml", "--converge", "many"}), HasSubstr("--converge"));
  EXPECT_THAT(refusal({"f.yaml", "--set"}), HasSubstr("--set"));
}
