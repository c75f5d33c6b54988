# With LIMES_PCH the headers of other projects are parsed once, which is a third of a build's time. Ours are left out:
# every file includes what it needs, as a build without LIMES_PCH tells.
set(LIMES_LIBRARY_HEADERS <Eigen/Core> <Eigen/Geometry> <Eigen/SparseCore> <algorithm> <array> <cmath> <functional> <map>
    <memory> <optional> <span> <string> <vector> <fmt/format.h>)

# limes_precompile(TARGET FIRST HEADERS): FIRST has the precompiled headers, which the others reuse.
function(limes_precompile target first headers)
  if(NOT LIMES_PCH)
    return()
  endif()
  if(target STREQUAL first)
    target_precompile_headers(${target} PRIVATE ${headers})
  else()
    target_precompile_headers(${target} REUSE_FROM ${first})
  endif()
endfunction()

# limes_module(NAME DEPENDS...): one library per folder of src/limes, named limes_NAME.
# DEPENDS are other modules (see scripts/check_layers.py) or imported targets.
function(limes_module name)
  file(GLOB sources CONFIGURE_DEPENDS ${name}/*.cpp)
  file(GLOB headers CONFIGURE_DEPENDS ${name}/*.h)
  if(sources)
    add_library(limes_${name} STATIC ${sources} ${headers})
    set(scope PUBLIC)
    limes_precompile(limes_${name} limes_core "${LIMES_LIBRARY_HEADERS}")
  else()
    add_library(limes_${name} INTERFACE)
    set(scope INTERFACE)
  endif()
  add_library(limes::${name} ALIAS limes_${name})
  target_include_directories(limes_${name} ${scope} ${PROJECT_SOURCE_DIR}/src)
  target_link_libraries(limes_${name} ${scope} ${ARGN})
endfunction()
