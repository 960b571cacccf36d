# Flags every target of the project shares. Determinism of the replicated state forbids contraction and fast-math.
add_library(coherency_flags INTERFACE)
target_include_directories(coherency_flags INTERFACE ${PROJECT_SOURCE_DIR})
target_compile_options(coherency_flags INTERFACE -Wall -Wextra -Wconversion -ffp-contract=off)
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
  target_compile_options(coherency_flags INTERFACE -Wno-restrict)  # false alarm in std::string, GCC bug 105651
endif()
if(COHERENCY_WERROR)
  target_compile_options(coherency_flags INTERFACE -Werror)
endif()
if(COHERENCY_SANITIZE)
  target_compile_options(coherency_flags INTERFACE -fsanitize=${COHERENCY_SANITIZE} -fno-omit-frame-pointer)
  target_link_options(coherency_flags INTERFACE -fsanitize=${COHERENCY_SANITIZE})
  if(COHERENCY_SANITIZE MATCHES "thread" AND CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    target_compile_options(coherency_flags INTERFACE -Wno-tsan)  # Boost.Asio has a fence, which GCC's TSan cannot see
  endif()
  if(COHERENCY_SANITIZE MATCHES "undefined")
    target_compile_options(coherency_flags INTERFACE -fno-sanitize-recover=undefined)
  endif()
endif()

# coherency_module(NAME SOURCES ... LINKS ...): one static library a folder. What stands in LINKS is the whole of
# what the folder may include; tests/architecture checks it.
function(coherency_module name)
  cmake_parse_arguments(arg "" "" "SOURCES;LINKS;PRIVATE_LINKS" ${ARGN})
  add_library(coherency_${name} STATIC ${arg_SOURCES})
  target_link_libraries(coherency_${name} PUBLIC coherency_flags ${arg_LINKS} PRIVATE ${arg_PRIVATE_LINKS})
endfunction()
