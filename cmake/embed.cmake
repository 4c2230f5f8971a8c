# Writes the bytes of IN as a C++ array called NAME to OUT.
file(READ ${IN} hex HEX)
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
