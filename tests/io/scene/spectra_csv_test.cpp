// Measured spectra as people export them, and as nobody should.
#include "io/scene/spectra_csv.h"

#include <gtest/gtest.h>

#include <ostream>
#include <string>
#include <vector>

#include "nacre/base/error.h"
#include "support/folders.h"

namespace nacre {
namespace {

using test::TemporaryFolder;

MeasuredSpectra spectra_of(const std::string& text) {
    const TemporaryFolder folder;
    return read_spectra_csv(folder.file("x.csv", text));
}

const MeasuredSpectra expected{
    "", {400.0, 500.0, 700.0}, {0.0, 15.0, 60.5}, {0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 9.5}};

struct Export {
    const char* name;
    std::string text;
};

void PrintTo(const Export& example, std::ostream* out) {
    *out << example.name;
}

const auto name_of_case = [](const auto& info) { return std::string(info.param.name); };

class GoodSpectra : public testing::TestWithParam<Export> {};

TEST_P(GoodSpectra, AreReadWhateverTheyWereExportedBy) {
    const MeasuredSpectra spectra = spectra_of(GetParam().text);
    EXPECT_EQ(spectra.wavelength_nm, expected.wavelength_nm);
    EXPECT_EQ(spectra.angle_deg, expected.angle_deg);
    EXPECT_EQ(spectra.reflectance, expected.reflectance);
}

// Of letters below U+0100, which Latin-1 has as one byte each.
std::string wide(const std::string& latin1, bool is_big_end) {
    std::string bytes;
    for (const char c : latin1) bytes += is_big_end ? std::string{'\0', c} : std::string{c, '\0'};
    return bytes;
}

const std::string body = "\n400,0.1,0.4,0.7\n500,0.2,0.5,0.8\n700,0.3,0.6,9.5\n";

INSTANTIATE_TEST_SUITE_P(
    Exports, GoodSpectra,
    testing::Values(
        Export{"Plain", "wavelength_nm,0,15,60.5" + body}, Export{"Zeros", "wavelength_nm,-0,15.000,6.05e1" + body},
        Export{"Signs", "wavelength_nm,+0,+15,60.5\n+400,+.1,4e-1,0.7\n500,2e-1,0.5,0.8\n700,0.3,0.6,9.5\n"},
        Export{"Degrees", "wavelength_nm,0 deg,15deg,60.5\xC2\xB0" + body},
        Export{"DegreesBehindABlank", "wavelength_nm,0 \xC2\xB0,15  deg,60.5" + body},
        Export{"Letters", "wavelength_nm,R_0,R_15,R_60.5" + body},
        Export{"LettersAndDegrees", "wavelength_nm,R_0 deg,R_15,R_60.5" + body},
        Export{"Quotes", "\"wavelength_nm\",\"0\",\"15\",\"60.5\"" + body},
        Export{"Semicolons", "wavelength_nm;0;15;60.5\n400;0.1;0.4;0.7\n500;0.2;0.5;0.8\n700;0.3;0.6;9.5\n"},
        Export{"Tabs", "wavelength_nm\t0\t15\t60.5\n400\t0.1\t0.4\t0.7\n500\t0.2\t0.5\t0.8\n700\t0.3\t0.6\t9.5\n"},
        Export{"Blanks",
               " wavelength_nm , 0 , 15 , 60.5 \n 400 , 0.1 , 0.4 , 0.7\n500, 0.2,0.5, 0.8 \n700,0.3,0.6,9.5"},
        Export{"WindowsLines",
               "\xEF\xBB\xBFwavelength_nm,0,15,60.5\r\n400,0.1,0.4,0.7\r\n500,0.2,0.5,0.8\r\n700,0.3,0.6,9.5\r\n"},
        Export{"Comments",
               "# a beetle\n\nwavelength_nm,0,15,60.5\n400,0.1,0.4,0.7\n# bump\n500,0.2,0.5,0.8\n\n700,0.3,"
               "0.6,9.5\n"},
        Export{"DecimalCommas", "wavelength_nm;0;15;60,5\n400;0,1;0,4;,7\n500;2e-1;0,5;0.8\n700;0,3;0,6;9,5\n"},
        Export{"DecimalCommasBetweenTabs",
               "wl\t0\t15\t60,5\n400\t0,1\t0,4\t0,7\n500\t,2\t0,5\t0,8\n700\t0,3\t0,6\t9,5\n"},
        Export{"Utf16",
               std::string("\xFF\xFE", 2) +
                   wide("wavelength_nm;0\xB0;15\xB0;60.5\xB0\n400;0.1;0.4;0.7\n500;0.2;0.5;0.8\n700;0.3;0.6;9.5\n",
                        false)},
        Export{"Utf16BigEnd", std::string("\xFE\xFF", 2) + wide("wavelength_nm,0,15,60.5" + body, true)},
        Export{"Latin1", "wavelength_nm,0\xB0,15\xB0,60.5 \xB0" + body},
        Export{
            "Preamble",
            "Instrument: X;12, serial 7\nDate,2024-05-01\n1,not a row of the table\nWavelength (nm),0,15,60.5" + body},
        Export{"Units", "Wavelength [nm],0,15,60.5\nnm,a.u.,a.u.,a.u.\n" + body.substr(1)},
        Export{"CapitalLetters", "WL,0,15,60.5" + body}, Export{"ShortName", "nm,0,15,60.5" + body},
        Export{"OtherName", "Lambda_nm,0,15,60.5" + body},
        Export{"LongestFirst", "wavelength_nm,0,15,60.5\n700,0.3,0.6,9.5\n500,0.2,0.5,0.8\n400,0.1,0.4,0.7\n"},
        Export{"AnglesInAnyOrder", "wavelength_nm,60.5,0,15\n400,0.7,0.1,0.4\n500,0.8,0.2,0.5\n700,9.5,0.3,0.6\n"}),
    name_of_case);

TEST(Spectra, MayBeOfOneAngle) {
    const MeasuredSpectra spectra = spectra_of("wavelength_nm,90\n1,0\n1e6,10\n");
    EXPECT_EQ(spectra.wavelength_nm, (std::vector<double>{1.0, 1e6}));
    EXPECT_EQ(spectra.angle_deg, std::vector<double>{90.0});
    EXPECT_EQ(spectra.reflectance, (std::vector<double>{0.0, 10.0}));
}

struct Mistake {
    const char* name;
    std::string text;
    std::string message;  // behind the file's name
};

void PrintTo(const Mistake& mistake, std::ostream* out) {
    *out << mistake.name;
}

class BadSpectra : public testing::TestWithParam<Mistake> {};

TEST_P(BadSpectra, AreOneLineThatSaysWhereAndWhat) {
    const TemporaryFolder folder;
    const std::string path = folder.file("x.csv", GetParam().text);
    try {
        read_spectra_csv(path);
        FAIL() << "was accepted";
    } catch (const Error& error) {
        EXPECT_EQ(error.what(), path + GetParam().message);
    }
}

std::string rows_of(int count, int angles) {
    std::string text = "wavelength_nm";
    for (int i = 0; i < angles; ++i) text += "," + std::to_string(0.01 * i);
    text += "\n";
    for (int i = 0; i < count; ++i) {
        text += std::to_string(i + 1);
        for (int j = 0; j < angles; ++j) text += ",1";
        text += "\n";
    }
    return text;
}

const std::string head = "wavelength_nm,0,15\n";

INSTANTIATE_TEST_SUITE_P(
    Mistakes, BadSpectra,
    testing::Values(
        Mistake{"Empty", "", ": is empty; give a heading, wavelength_nm and angles, and rows of numbers"},
        Mistake{"CommentsOnly", "# nothing\n\n",
                ": is empty; give a heading, wavelength_nm and angles, and rows of numbers"},
        Mistake{"NoHeading", "400,0.1\n500,0.2\n",
                ":1:1: \"400\" heads the first column; a table of spectra begins with wavelength_nm, then an angle in "
                "degrees per column"},
        Mistake{"Micrometres", "wavelength_um,0\n0.4,0.1\n0.5,0.2\n",
                ":1:1: \"wavelength_um\" heads the first column; a table of spectra begins with wavelength_nm, then an "
                "angle in degrees per column"},
        Mistake{"MicrometresUnderAFalseHeading", head + "0.4,0.1,0.1\n0.5,0.2,0.2\n",
                ":2:1: wavelength 0.4 is out of range; allowed [1, 1000000] nm"},
        Mistake{"NoAngle", "wavelength_nm\n400\n500\n",
                ":1:1: the heading has no angle; give one or more, such as wavelength_nm,0,45"},
        Mistake{"HeadingOnly", head, ": has 0 wavelengths; spectra need two or more"},
        Mistake{"OneWavelength", head + "400,0.1,0.1\n", ": has 1 wavelengths; spectra need two or more"},
        Mistake{"AngleInWords", "wavelength_nm,normal\n400,0\n500,0\n",
                ":1:15: heading \"normal\" is not an angle; give degrees, such as 15, or choose this specimen with "
                "column = \"normal\""},
        Mistake{"AngleInRadians", "wavelength_nm,0.5 rad\n400,0\n500,0\n",
                ":1:15: heading \"0.5 rad\" is not an angle; give degrees, such as 15, or choose this specimen with "
                "column = \"0.5 rad\""},
        Mistake{"EmptyAngle", "wavelength_nm,0,,30\n400,0,0,0\n500,0,0,0\n",
                ":1:17: heading \"\" is not an angle; give degrees, such as 15"},
        Mistake{"SeparatorAtTheEnd", "wavelength_nm,0,\n400,0,\n500,0,\n",
                ":1:17: heading \"\" is not an angle; give degrees, such as 15"},
        Mistake{"TwoSigns", "wavelength_nm,+-5\n400,0\n500,0\n",
                ":1:15: angle -5 is out of range; allowed [0, 90] degrees"},
        Mistake{"NegativeAngle", "wavelength_nm,-15\n400,0\n500,0\n",
                ":1:15: angle -15 is out of range; allowed [0, 90] degrees"},
        Mistake{"AngleBeyondGrazing", "wavelength_nm,0,90.001\n400,0,0\n500,0,0\n",
                ":1:17: angle 90.001 is out of range; allowed [0, 90] degrees"},
        Mistake{"AngleThatIsNoNumber", "wavelength_nm,nan\n400,0\n500,0\n",
                ":1:15: angle nan is out of range; allowed [0, 90] degrees"},
        Mistake{"AngleOfManyDigits", "wavelength_nm,1e999\n400,0\n500,0\n",
                ":1:15: heading \"1e999\" is not an angle; give degrees, such as 15, or choose this specimen with "
                "column = \"1e999\""},
        Mistake{"AngleTwice", "wavelength_nm,15,0,15.0 deg\n400,0,0,0\n500,0,0,0\n",
                ":1:20: angle 15 has two columns; give every angle once"},
        Mistake{"ZeroTwice", "wavelength_nm,0,-0\n400,0,0\n500,0,0\n",
                ":1:17: angle 0 has two columns; give every angle once"},
        Mistake{"RowTooShort", head + "400,0.1,0.1\n500,0.2\n", ":3: has 2 fields; the heading has 3"},
        Mistake{
            "RowTooLong", head + "400,0.1,0.1\n\n500,0.2,0.2,0.2\n",
            ":4:13: has 4 fields; the heading has 3 (decimal commas need a semicolon or a tab between the columns)"},
        Mistake{
            "Hole", head + "400,,0.1\n500,0.2,0.2\n",
            ":2:5: the value is missing; fill it in, or delete the row: nacre interpolates between the rows that are "
            "left"},
        Mistake{"NotApplicable", head + "400,0.1,#N/A\n500,0.2,0.2\n",
                ":2:9: the value is missing (\"#N/A\"); fill it in, or delete the row: nacre interpolates between the "
                "rows that are left"},
        Mistake{
            "QuotedHole", head + "400,0.1,\"\"\n500,0.2,0.2\n",
            ":2:9: the value is missing; fill it in, or delete the row: nacre interpolates between the rows that are "
            "left"},
        Mistake{"NoWavelength", head + ",0.1,0.1\n500,0.2,0.2\n", ":2:1: \"\" is not a finite number"},
        Mistake{"Words", head + "400,0.1,bright\n500,0.2,0.2\n", ":2:9: \"bright\" is not a finite number"},
        Mistake{"DecimalCommasBetweenCommas", head + "400,0,1,0,1\n500,0,2,0,2\n",
                ":2:9: has 5 fields; the heading has 3 (decimal commas need a semicolon or a tab between the columns)"},
        Mistake{"Thousands", "wavelength_nm;0\n400;0.001,5\n500;0,2\n", ":2:5: \"0.001,5\" is not a finite number"},
        Mistake{
            "PercentInTheHeading", "wavelength_nm,0 %\n400,8\n500,9\n",
            ":1:15: heading \"0 %\" is not an angle; give degrees, such as 15, or choose this specimen with column = "
            "\"0 %\""},
        Mistake{"PercentInTheUnits", "wavelength_nm,0\nnm,%\n400,8\n500,9\n",
                ":1:1: the heading says percent; write unit = \"percent\" in the scene, or unit = \"fraction\" if the "
                "values are fractions"},
        Mistake{"MicrometresFrom1", "wavelength_nm,0\n1,8\n2.5,9\n",
                ":2:1: wavelengths end at 2.5 nm, as if they were micrometres; give nanometres"},
        Mistake{"Hexadecimal", head + "400,0x1,0.1\n500,0.2,0.2\n", ":2:5: \"0x1\" is not a finite number"},
        Mistake{
            "NotANumber", head + "400,nan,0.1\n500,0.2,0.2\n",
            ":2:5: the value is missing (\"nan\"); fill it in, or delete the row: nacre interpolates between the rows "
            "that are left"},
        Mistake{"Infinite", head + "400,inf,0.1\n500,0.2,0.2\n", ":2:5: \"inf\" is not a finite number"},
        Mistake{"Overflow", head + "400,1e400,0.1\n500,0.2,0.2\n", ":2:5: \"1e400\" is not a finite number"},
        Mistake{"Negative", head + "400,-0.001,0.1\n500,0.2,0.2\n",
                ":2:5: reflectance -0.001 is negative; allowed [0, 10]; write negative = \"clip\" in the scene if it "
                "is noise"},
        Mistake{"Percent", head + "400,9,9\n500,45.5,8\n",
                ":3:5: reflectance 45.5 is out of range; allowed [0, 10]; write unit = \"percent\" in the scene if it "
                "is percent"},
        Mistake{"NegativeWavelength", head + "-400,0,0\n500,0,0\n",
                ":2:1: wavelength -400 is out of range; allowed [1, 1000000] nm"},
        Mistake{"WavelengthTwice", head + "400,0,0\n400,0,0\n",
                ":3:1: wavelength 400 does not ascend; give every wavelength once, smallest or largest first"},
        Mistake{"UpAndDown", head + "400,0,0\n700,0,0\n500,0,0\n",
                ":4:1: wavelength 500 does not ascend; give every wavelength once, smallest or largest first"},
        Mistake{"HeadingTwice", head + head + "400,0,0\n500,0,0\n", ":2:1: \"wavelength_nm\" is not a finite number"},
        Mistake{"TooManyValues", rows_of(1000, 1001), ": has 1001000 values; allowed 1000000"}),
    name_of_case);

// What a scene says beside the name of a table.
MeasuredSpectra spectra_with(const CsvKeys& keys, const std::string& text) {
    const TemporaryFolder folder;
    return read_spectra_csv(folder.file("x.csv", text), keys);
}

std::string message_with(const CsvKeys& keys, const std::string& text) {
    const TemporaryFolder folder;
    const std::string path = folder.file("x.csv", text);
    try {
        read_spectra_csv(path, keys);
    } catch (const Error& error) {
        return std::string(error.what()).substr(path.size());
    }
    return "no error";
}

const std::string specimens = "Wavelength (nm),Gold,Teal %R,Gold leaf\nnm,%,%,%\n400,8,1.5,-0.2\n700,90.5,-0.3,3\n";

TEST(Spectra, MayBeOneOfSeveralSpecimensInPercent) {
    const MeasuredSpectra gold = spectra_with({true, "Gold", true, false}, specimens);
    EXPECT_EQ(gold.wavelength_nm, (std::vector<double>{400.0, 700.0}));
    EXPECT_EQ(gold.angle_deg, std::vector<double>{0.0});
    EXPECT_EQ(gold.reflectance, (std::vector<double>{0.08, 0.905}));
    EXPECT_EQ(spectra_with({true, "Gold", false, false}, "nm,Gold\n400,8\n700,9.05\n").reflectance,
              (std::vector<double>{8.0, 9.05}));
}

TEST(Spectra, LoseTheirNoiseBelowZeroIfTheSceneSaysSo) {
    EXPECT_EQ(spectra_with({true, "Teal %R", true, true}, specimens).reflectance, (std::vector<double>{0.015, 0.0}));
    EXPECT_EQ(
        message_with({true, "Teal %R", true, false}, specimens),
        ":4:10: reflectance -0.3 is negative; allowed [0, 10]; write negative = \"clip\" in the scene if it is noise");
    EXPECT_EQ(message_with({true, "a", {}, true}, "nm,a\n400,0.5\n700,-0.06\n"),
              ":3:5: reflectance -0.06 is negative; noise is -0.05 of white or more");
}

TEST(Spectra, OfAnUnknownSpecimenAreAnsweredWithTheNearest) {
    EXPECT_EQ(message_with({true, "Godl", true, false}, specimens), ": has no column \"Godl\"; known: Gold");
    EXPECT_EQ(message_with({true, "a", {}, false}, "nm,a,b,a\n400,1,1,1\n500,1,1,1\n"),
              ":1:4: two columns are headed \"a\"; give every column a name of its own");
    EXPECT_EQ(message_with({true, "a", {}, false}, "400,1\n500,1\n"),
              ": has no column \"a\"; the table has no heading");
    EXPECT_EQ(message_with({true, "Gold", true, false}, "nm,Gold\n400,8\n700,1001\n"),
              ":3:5: reflectance 1001 is out of range; allowed [0, 1000] percent");
}

TEST(Spectra, OfAMissingFileAreNoMistakeOfTheText) {
    EXPECT_THROW(read_spectra_csv("/nowhere/x.csv"), IoError);
}

TEST(Spectra, OfBytesThatAreNoTextAreRefused) {
    std::string bytes;
    for (int i = 0; i < 4096; ++i) bytes += static_cast<char>(i * 7919 % 256);
    EXPECT_THROW(spectra_of(bytes), Error);
    EXPECT_THROW(spectra_of(std::string("wavelength_nm,0\n400,0\0\n500,0\n", 29)), Error);
}

}  // namespace
}  // namespace nacre
