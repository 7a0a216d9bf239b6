# cmake -D BUILD=... -D SOURCE=... -D FOLDER=... -D VERSION=... -D COMPILER=... -D FLAGS=... -D BUILD_TYPE=... -P
function(run)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE code OUTPUT_VARIABLE said ERROR_VARIABLE complained)
  if(NOT code EQUAL 0)
    list(JOIN ARGN " " command)
    message(FATAL_ERROR "${command}: ${code}\n${said}${complained}")
  endif()
  set(said "${said}" PARENT_SCOPE)
endfunction()

file(REMOVE_RECURSE ${FOLDER})
run(${CMAKE_COMMAND} --install ${BUILD} --prefix ${FOLDER}/prefix)

run(${FOLDER}/prefix/bin/fluidymation --version)
if(NOT said STREQUAL "fluidymation ${VERSION}\n")
  message(FATAL_ERROR "the installed program says: ${said}")
endif()
foreach(file share/man/man1/fluidymation.1 share/bash-completion/completions/fluidymation
    share/zsh/vendor-completions/_fluidymation share/doc/fluidymation/copyright)
  if(NOT EXISTS ${FOLDER}/prefix/${file})
    message(FATAL_ERROR "not installed: ${file}")
  endif()
endforeach()

# Nothing that is installed knows where it was built.
file(GLOB_RECURSE descriptions ${FOLDER}/prefix/*.cmake)
foreach(file IN LISTS descriptions)
  file(READ ${file} text)
  string(FIND "${text}" "${BUILD}" place)
  if(NOT place EQUAL -1)
    message(FATAL_ERROR "${file} names the build folder")
  endif()
endforeach()

run(${CMAKE_COMMAND} -S ${SOURCE} -B ${FOLDER}/build -D CMAKE_PREFIX_PATH=${FOLDER}/prefix
  -D CMAKE_CXX_COMPILER=${COMPILER} -DCMAKE_CXX_FLAGS=${FLAGS} -D CMAKE_BUILD_TYPE=${BUILD_TYPE})
run(${CMAKE_COMMAND} --build ${FOLDER}/build)
run(${FOLDER}/build/consumer)
if(NOT said MATCHES "^${VERSION}: .*nowhere")
  message(FATAL_ERROR "the linked program says: ${said}")
endif()
