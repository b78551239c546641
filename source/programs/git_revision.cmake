# Writes the version header with the revision of the sources, whenever that has changed.
# Variables: SOURCE_DIR, TEMPLATE, HEADER, PROJECT_VERSION
execute_process(COMMAND git -C ${SOURCE_DIR} describe --always --dirty --exclude *
                OUTPUT_VARIABLE RINGMOTOR_GIT_REVISION OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
if(NOT RINGMOTOR_GIT_REVISION)
  set(RINGMOTOR_GIT_REVISION "revision unknown")
endif()
configure_file(${TEMPLATE} ${HEADER} @ONLY)
