# Writes the bytes of IN as a C++ array called NAME to OUT; of a shader's text without comments, indents and empty lines.
if(IN MATCHES "\\.(glsl|vert|frag|comp)$")
  file(READ ${IN} text)
  string(REGEX REPLACE "[ \t]*//[^\n]*" "" text "${text}")
  string(REGEX REPLACE "\n[ \t\n]+" "\n" text "${text}")
  string(REGEX REPLACE "^\n" "" text "${text}")
  string(HEX "${text}" hex)
else()
  file(READ ${IN} hex HEX)
endif()
string(LENGTH "${hex}" digits)
math(EXPR bytes "${digits} / 2")
string(REGEX REPLACE "(..)" "0x\\1," body "${hex}")
string(REGEX REPLACE "(0x..,0x..,0x..,0x..,0x..,0x..,0x..,0x..,0x..,0x..,0x..,0x..,0x..,0x..,0x..,0x..,)" "\\1\n" body "${body}")
file(WRITE ${OUT} "namespace marrow::embedded {
extern const unsigned char ${NAME}[];
extern const unsigned long long ${NAME}_size;
alignas(16) const unsigned char ${NAME}[] = {
${body}0};
const unsigned long long ${NAME}_size = ${bytes};
}
")
