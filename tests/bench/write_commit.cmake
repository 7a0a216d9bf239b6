# Writes HEADER with the commit of the checkout REPOSITORY, if it has changed.
execute_process(
  COMMAND git -C ${REPOSITORY} describe --always --dirty --exclude=* --abbrev=12
  OUTPUT_VARIABLE commit OUTPUT_STRIP_TRAILING_WHITESPACE
  RESULT_VARIABLE failure ERROR_QUIET)
if(failure)
  set(commit unknown)
endif()
file(CONFIGURE OUTPUT ${HEADER} @ONLY CONTENT [[
#pragma once

#define FLUIDYMATION_COMMIT "@commit@"
]])
