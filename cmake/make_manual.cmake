# Writes the manual page, made from what the command says of itself.
#   cmake -D COMMAND=sightline -D VERSION=X.Y.Z -D OUT=FILE -P make_manual.cmake

# A help has 30 columns for names; where these take more, what they mean is on the next line.
set(name_width 30)

function(help_of out)
  execute_process(COMMAND "${COMMAND}" ${ARGN} --help OUTPUT_VARIABLE help COMMAND_ERROR_IS_FATAL ANY)
  string(REPLACE "\\" "\\e" help "${help}")
  set(${out} "${help}" PARENT_SCOPE)
endfunction()

# The two parts of a line of the help.
function(parts_of line name meaning)
  string(LENGTH "${line}" length)
  set(left "${line}")
  set(right "")
  if(length GREATER name_width)
    string(SUBSTRING "${line}" 0 ${name_width} left)
    string(SUBSTRING "${line}" ${name_width} -1 right)
    if(NOT left MATCHES " $")
      set(left "${line}")
      set(right "")
    endif()
  endif()
  string(STRIP "${left}" left)
  set(${name} "${left}" PARENT_SCOPE)
  set(${meaning} "${right}" PARENT_SCOPE)
endfunction()

# Names with what they mean, and examples.
function(entries_of help out)
  set(page "")
  string(REPLACE ";" "\\;" help "${help}")
  string(REPLACE "\n" ";" lines "${help}")
  foreach(line IN LISTS lines)
    parts_of("${line}" name meaning)
    if(line MATCHES "^Example: (.*)$")
      string(APPEND page ".PP\nExample:\n.B ${CMAKE_MATCH_1}\n")
    elseif(line MATCHES "^  " AND NOT name STREQUAL "")
      string(APPEND page ".TP\n.B ${name}\n")
    endif()
    if(NOT meaning STREQUAL "" AND line MATCHES "^  ")
      string(APPEND page "${meaning}\n")
    endif()
  endforeach()
  set(${out} "${page}" PARENT_SCOPE)
endfunction()

help_of(main)
string(REGEX MATCH "^sightline: ([^\n]+)\nUsage: ([^\n]+)\n" head "${main}")
set(page ".TH SIGHTLINE 1 \"\" \"sightline ${VERSION}\" \"User Commands\"\n.nh\n.ad l\n")
string(APPEND page ".SH NAME\nsightline - ${CMAKE_MATCH_1}\n.SH SYNOPSIS\n.B ${CMAKE_MATCH_2}\n.SH DESCRIPTION\n")
string(REGEX REPLACE "Example: .*$" "" main_without_examples "${main}")
entries_of("${main_without_examples}" entries)
string(APPEND page "${entries}")

string(REGEX MATCH "\nSubcommands:\n(.*)\n\n" subcommands "${main}")
string(REGEX MATCHALL "\n  [a-z]+" names "${subcommands}")
foreach(name IN LISTS names)
  string(STRIP "${name}" name)
  help_of(help ${name})
  string(REGEX MATCH "^([^\n]+)\nUsage: ([^\n]+)\n" head "${help}")
  string(APPEND page ".SH sightline ${name}\n${CMAKE_MATCH_1}.\n.PP\n.B ${CMAKE_MATCH_2}\n")
  entries_of("${help}" entries)
  string(APPEND page "${entries}")
endforeach()

string(APPEND page ".SH EXIT STATUS
.TP
0
Done.
.TP
1
The input is wrong, or there is not enough memory or disk.
.TP
2
The command line is wrong.
.TP
3
An internal error.
")
string(REPLACE "-" "\\-" page "${page}")  # a minus to copy, no hyphen
file(WRITE "${OUT}" "${page}")
