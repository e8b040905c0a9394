# What every target of the project shares: the language, the warnings, no contraction of a*b+c behind our back
# (kernels/dialect.h: fma is written where the algebra needs it), and the sanitizer of the preset.
add_library(tyndall_build INTERFACE)
target_compile_features(tyndall_build INTERFACE cxx_std_20)
target_compile_options(tyndall_build INTERFACE -Wall -Wextra -Wpedantic -Wno-missing-field-initializers $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict> -ffp-contract=off)
target_include_directories(tyndall_build INTERFACE ${PROJECT_SOURCE_DIR}/host ${PROJECT_SOURCE_DIR}/host/include ${PROJECT_SOURCE_DIR})
if(TYNDALL_SANITIZE)
  target_compile_options(tyndall_build INTERFACE -fsanitize=${TYNDALL_SANITIZE} -fno-omit-frame-pointer -fno-sanitize-recover=all)
  target_link_options(tyndall_build INTERFACE -fsanitize=${TYNDALL_SANITIZE})
endif()

# tyndall_part(NAME SOURCES a.cpp b.cpp USES other targets): one folder of host/ as a static library.
function(tyndall_part name)
  cmake_parse_arguments(PART "" "" "SOURCES;USES;PRIVATE_USES" ${ARGN})
  add_library(${name} STATIC ${PART_SOURCES})
  target_link_libraries(${name} PUBLIC tyndall_build ${PART_USES} PRIVATE ${PART_PRIVATE_USES})
  set_target_properties(${name} PROPERTIES POSITION_INDEPENDENT_CODE ON)
endfunction()
