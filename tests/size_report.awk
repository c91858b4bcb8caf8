# Says which files and functions are longer than the style allows: sources 300 lines, headers 150, functions 40.
#
#   awk -f tests/size_report.awk FILE...
#
# These are reports: the exit code is 0. A function of more than 60 lines in src/nacre/accuracy or src/nacre/scene is an
# error: the exit code is 1. The files are formatted by clang-format, so that a line tells by its first column where a
# function ends: "}" at the margin, or one step in within a class. Data that a table holds ends with "};" and is no function.

function finish_file() {
    if (file != "" && lines > (file ~ /\.h$/ ? 150 : 300)) print file ": " lines " lines"
}

function finish_function(first, length_limit) {
    length_of = FNR - first - 1
    if (length_of <= 40) return
    too_long = length_of > 60 && FILENAME ~ /src\/nacre\/(accuracy|scene)\//
    if (too_long) failed = 1
    print FILENAME ":" first ": " (too_long ? "error: " : "") "a function of " length_of " lines"
}

FNR == 1 { finish_file(); file = FILENAME; first = 0; in_class = 0; method = 0; head = "" }
{ lines = FNR }

# A declaration starts at the margin; its opening brace may stand some lines below.
/^[A-Za-z]/ { if (!first) head = $0 }
/^(inline )?namespace/ { head = ""; next }

/^}$/ { if (first && !in_class) finish_function(first); first = 0; in_class = 0; next }
/^}/ { first = 0; in_class = 0; method = 0; next }
!first && head != "" && /\{$/ { first = FNR; in_class = head ~ /^(class|struct|union|template.*(class|struct) [A-Z][A-Za-z]* )/; next }
in_class && !method && /^    [A-Za-z].*\{$/ { method = FNR; next }
in_class && !method && /^        .*\) (const |noexcept |override )*\{$/ { method = FNR; next }
in_class && /^    }/ { if (method && /^    }$/) finish_function(method); method = 0; next }

END { finish_file(); exit failed }
