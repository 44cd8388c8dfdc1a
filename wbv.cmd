@echo off
rem Runs wbv from any folder on Windows; builds it first when a source is newer than the jar. The shell's launcher beside it is wbv.
setlocal EnableExtensions DisableDelayedExpansion
set "home=%~dp0"
set "home=%home:~0,-1%"
set "jar=%home%\target\wbv.jar"

rem JAVA_HOME goes before the PATH, for Maven too.
set "java=java"
if defined JAVA_HOME if exist "%JAVA_HOME%\bin\java.exe" set "java=%JAVA_HOME%\bin\java.exe"
if "%java%"=="java" where /q java
if "%java%"=="java" if errorlevel 1 (
  echo wbv: java is not on the PATH and JAVA_HOME names none; wbv needs a JDK 17 and Maven 3.8 or newer>&2
  exit /b 3
)

rem The fleet on many machines needs Apache Flink, which this launcher does not build: fleet runs in one process here.
set "WBV_HOME=%home%"
call :stale
if errorlevel 1 goto run

where /q mvn
if errorlevel 1 (
  echo wbv: mvn is not on the PATH; wbv needs a JDK 17 and Maven 3.8 or newer>&2
  exit /b 3
)
if not exist "%home%\target" mkdir "%home%\target"
echo wbv: building (the first time also downloads its libraries) ...>&2
call mvn -B -q -f "%home%\pom.xml" -Dmaven.test.skip=true package >"%home%\target\build.log" 2>&1 <nul
if errorlevel 1 (
  type "%home%\target\build.log">&2
  echo wbv: the build failed; the lines above say why>&2
  exit /b 3
)
rem A build that had nothing to change leaves an old jar: it is as new as its sources now.
powershell -NoProfile -NonInteractive -Command "(Get-Item -LiteralPath (Join-Path $env:WBV_HOME 'target\wbv.jar')).LastWriteTimeUtc = [DateTime]::UtcNow" <nul

:run
rem wbv writes UTF-8, which a console shows under code page 65001; it has its own back afterwards.
for /f "tokens=2 delims=:" %%p in ('chcp') do set "page=%%p"
set "page=%page:.=%"
chcp 65001 >nul
"%java%" -Dfile.encoding=UTF-8 %WBV_JAVA_OPTS% -jar "%jar%" %*
set "code=%errorlevel%"
chcp %page% >nul
exit /b %code%

rem 0 where the jar is missing or older than pom.xml or a source, else 1. PowerShell compares times; cmd cannot.
:stale
if not exist "%jar%" exit /b 0
if not exist "%home%\target\lib" exit /b 0
powershell -NoProfile -NonInteractive -Command "$jar = (Get-Item -LiteralPath (Join-Path $env:WBV_HOME 'target\wbv.jar')).LastWriteTimeUtc; $pom = Get-Item -LiteralPath (Join-Path $env:WBV_HOME 'pom.xml'); $new = @($pom) + @(Get-ChildItem -Recurse -LiteralPath (Join-Path $env:WBV_HOME 'src\main')) | Where-Object { $_.LastWriteTimeUtc -gt $jar } | Select-Object -First 1; if ($new) { exit 0 } else { exit 1 }" <nul
exit /b %errorlevel%
