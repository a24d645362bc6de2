@echo off
rem Starts Phrenic with the Java of JAVA_HOME, or else with that on the path.
setlocal
set "JAVA=java"
if exist "%JAVA_HOME%\bin\java.exe" set "JAVA=%JAVA_HOME%\bin\java.exe"
"%JAVA%" %PHRENIC_JAVA_OPTIONS% -jar "%~dp0phrenic.jar" %*
exit /b %ERRORLEVEL%
