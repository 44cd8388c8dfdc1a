# wbv in a container: built with Maven, run by a Java alone, as nobody in particular.
#
#   docker build -t wbv .
#   docker run --rm -v "$PWD:/data" wbv analyze ride.csv --out out
#
# The folder must be writable for user 1000; add --user "$(id -u):$(id -g)" where yours is another.
FROM maven:3.9-eclipse-temurin-17 AS build
WORKDIR /wbv
COPY pom.xml ./
COPY src/main src/main
RUN mvn -B -q -Dmaven.test.skip=true package

FROM eclipse-temurin:17-jre
ENV LANG=C.UTF-8 DJL_CACHE_DIR=/tmp/djl
COPY LICENSE /opt/wbv/
COPY --from=build /wbv/target/lib /opt/wbv/lib
COPY --from=build /wbv/target/wbv.jar /opt/wbv/
# Java starts faster from an archive of its classes; it serves this jar in this place.
COPY data/arff/one-dof-linear.arff /tmp/
RUN java -XX:ArchiveClassesAtExit=/opt/wbv/classes.jsa -Xlog:disable -jar /opt/wbv/wbv.jar analyze /tmp/one-dof-linear.arff --out /tmp/out && rm -r /tmp/*
WORKDIR /data
USER 1000:1000
ENTRYPOINT ["java", "-XX:SharedArchiveFile=/opt/wbv/classes.jsa", "-Xlog:cds=off", "-jar", "/opt/wbv/wbv.jar"]
