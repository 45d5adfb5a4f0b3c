# How the sources of a room become a library. The order of sources decides nothing: what the compiler may fuse does not hang on what
# else it sees, and no function of a kernel exists twice (tests/regression/nightly_file_order.sh).
option(CAGETOL_REVERSE_SOURCES "Take sources in reversed order, to see that it decides nothing" OFF)

# Sums of products may be fused within an expression (clang does; GCC takes `on` for `off`): never across calls, where it would hang
# on what is inlined, which hangs on the sources compiled together.
add_compile_options(-ffp-contract=on)

# Kernels fuse wherever they can. What is inlined decides their bits, so each is compiled alone and has its own copy of every
# inline function and template: weak ones the linker would choose by the order of files.
set(cagetol_kernel_options $<$<CXX_COMPILER_ID:GNU>:-ffp-contract=fast> $<$<CXX_COMPILER_ID:GNU>:-fwhole-program>)

# A library of every C++ file of some folders:
#   cagetol_room(NAME [OBJECT] FOLDERS FOLDER... [WITHOUT FILE...] [WITH FILE...] [KERNELS FILE...] [ALONE FILE...] [OPTIONS OPTION...])
# WITHOUT: files that are not the library's; WITH: others that are; KERNELS: files whose arithmetic takes the time of a run; ALONE:
# files compiled by themselves; OPTIONS: of the compiler.
function(cagetol_room name)
  cmake_parse_arguments(PARSE_ARGV 1 room OBJECT "" "FOLDERS;WITHOUT;WITH;KERNELS;ALONE;OPTIONS")
  list(TRANSFORM room_FOLDERS APPEND /*.cpp OUTPUT_VARIABLE patterns)
  file(GLOB sources CONFIGURE_DEPENDS RELATIVE ${CMAKE_CURRENT_SOURCE_DIR} ${patterns})
  foreach(file ${room_WITHOUT} ${room_KERNELS} ${room_ALONE})
    if(NOT file IN_LIST sources)
      message(FATAL_ERROR "${name}: no source ${file}")
    endif()
  endforeach()
  if(room_WITHOUT)
    list(REMOVE_ITEM sources ${room_WITHOUT})
  endif()
  list(APPEND sources ${room_WITH})
  if(CAGETOL_REVERSE_SOURCES)
    list(REVERSE sources)
  endif()
  if(room_OBJECT)
    add_library(${name} OBJECT ${sources})
  else()
    add_library(${name} STATIC ${sources})
  endif()
  target_compile_options(${name} PRIVATE ${room_OPTIONS})
  if(NOT DEFINED CMAKE_UNITY_BUILD)
    set_target_properties(${name} PROPERTIES UNITY_BUILD ON)
  endif()
  set_source_files_properties(${room_KERNELS} ${room_ALONE} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
  if(room_KERNELS)
    set_source_files_properties(${room_KERNELS} PROPERTIES COMPILE_OPTIONS "${cagetol_kernel_options}")
  endif()
endfunction()
