# limes_embed_text(TARGET NAME FILE): the text of FILE becomes the string limes::embedded::NAME.
# Declared in report/embedded.h.
function(limes_embed_text target name file)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${CMAKE_CURRENT_LIST_DIR}/report/${file})
  file(READ report/${file} text)
  set(generated ${CMAKE_CURRENT_BINARY_DIR}/embedded_${name}.cpp)
  file(CONFIGURE OUTPUT ${generated} @ONLY CONTENT
"// Made from @file@.
#include \"limes/report/embedded.h\"

const std::string_view limes::embedded::@name@ = R\"embedded(@text@)embedded\";
")
  target_sources(${target} PRIVATE ${generated})
endfunction()
