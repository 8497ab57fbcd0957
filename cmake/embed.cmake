# cmake -DFILE=F -DNAME=N -DOUTPUT=H -P embed.cmake: writes the header H in which epsnet::N is the text of the file F.
file(READ ${FILE} text)
file(WRITE ${OUTPUT} "#pragma once\n\n#include <string_view>\n\nnamespace epsnet {\ninline constexpr std::string_view ${NAME} = R\"embedded(${text})embedded\";\n}\n")
