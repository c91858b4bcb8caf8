#include "io/disk/output_folder.h"

#include <gtest/gtest.h>

#include <fstream>

#include "nacre/base/error.h"
#include "support/folders.h"

namespace nacre {
namespace {

TEST(OutputFolder, NothingIsInPlaceBeforeTheCommitAndAllOfItAfter) {
    const test::TemporaryFolder scratch;
    OutputFolder folder(scratch.path().string());
    folder.write("a", "one");
    folder.write("b", "two");
    EXPECT_FALSE(std::filesystem::exists(scratch.path() / "a"));
    folder.commit();
    EXPECT_EQ(scratch.names(), (std::vector<std::string>{"a", "b"}));
    EXPECT_EQ(test::file_bytes(scratch.path() / "b"), "two");
    EXPECT_TRUE(folder.holds("a", "one"));
    EXPECT_FALSE(folder.holds("a", "eno"));
}

TEST(OutputFolder, WhatTheDiskDoesNotGiveBackIsNeverPutIntoPlace) {
    const test::TemporaryFolder scratch;
    std::ofstream(scratch.path() / "a") << "the old one";
    {
        OutputFolder folder(scratch.path().string());
        folder.write("a", "hello");
        for (const std::string& name : scratch.names()) {
            if (name != "a") std::ofstream(scratch.path() / name) << "hellx";  // a disk that lies
        }
        EXPECT_THROW(folder.commit(), IoError);
    }
    EXPECT_EQ(scratch.names(), std::vector<std::string>{"a"}) << "the temporary file goes with the folder's object";
    EXPECT_EQ(test::file_bytes(scratch.path() / "a"), "the old one");
}

}  // namespace
}  // namespace nacre
