# cmake -DFILE=F -DNAME=N -DHEADER=H -DOUTPUT=C -P embed.cmake: writes the source C, which defines epsnet::N, declared in H, as the text of F.
file(READ ${FILE} text)
file(WRITE ${OUTPUT} "#include \"${HEADER}\"\n\nnamespace epsnet {\nconst std::string_view ${NAME} = R\"embedded(${text})embedded\";\n}\n")
