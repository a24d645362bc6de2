package org.phrenic.file;

import java.io.File;
import java.io.IOException;
import java.net.URISyntaxException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.security.CodeSource;
import java.util.Arrays;
import java.util.Comparator;
import java.util.Enumeration;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import java.util.zip.ZipEntry;
import java.util.zip.ZipFile;

/** Identifies the code that computes: the program's jars by the checksums of their entries, the libraries by name. */
final class BuildIdentity {
    /** Jars of the program whose code or data decides how a body and its scene are computed. */
    private static final String[] COMPUTING = {"phrenic-engine-", "phrenic-mesh-", "phrenic-thorax-"};

    private static final long ODD = 0x9E37_79B9_7F4A_7C15L;

    private BuildIdentity() {}

    /**
     * The identity of the running program and its Java; empty if its classes do not come from jars, as in a development
     * environment. The jars lie in one folder, or each stands on the class path.
     */
    static Optional<String> ofProgram() {
        CodeSource source = BuildIdentity.class.getProtectionDomain().getCodeSource();
        if (source == null) {
            return Optional.empty();
        }
        try {
            Path jar = Path.of(source.getLocation().toURI());
            return isJar(jar)
                    ? ofFolder(jar.getParent()).or(() -> ofClassPath(System.getProperty("java.class.path", "")))
                    : Optional.empty();
        } catch (URISyntaxException | IllegalArgumentException e) {
            return Optional.empty();
        }
    }

    /** A jar of the program or of a library, not of tests. */
    private static boolean isJar(Path file) {
        String name = file.toString();
        return name.endsWith(".jar") && !name.endsWith("-tests.jar");
    }

    /** The identity of the jars in a folder; empty if one of the program's is missing. */
    static Optional<String> ofFolder(Path folder) {
        try (Stream<Path> files = Files.list(folder)) {
            return ofJars(files.filter(BuildIdentity::isJar));
        } catch (IOException e) {
            return Optional.empty();
        }
    }

    /** The identity of the jars of a class path; empty if one of the program's is missing or is a folder of classes. */
    static Optional<String> ofClassPath(String classPath) {
        try {
            return ofJars(
                    Stream.of(classPath.split(File.pathSeparator)).map(Path::of).filter(BuildIdentity::isJar));
        } catch (IOException e) {
            return Optional.empty();
        }
    }

    private static Optional<String> ofJars(Stream<Path> jars) throws IOException {
        StringBuilder text = new StringBuilder()
                .append(System.getProperty("java.vm.version"))
                .append(' ')
                .append(System.getProperty("os.arch"));
        int found = 0;
        List<Path> sorted =
                jars.sorted(Comparator.comparing(BuildIdentity::name)).toList();
        for (Path jar : sorted) {
            String name = name(jar);
            if (Arrays.stream(COMPUTING).anyMatch(name::startsWith)) {
                found++;
                text.append(' ').append(Long.toHexString(checksum(jar.toFile())));
            } else if (!name.startsWith("phrenic-")) {
                text.append(' ').append(name);
            }
        }
        return found == COMPUTING.length ? Optional.of(text.toString()) : Optional.empty();
    }

    private static String name(Path jar) {
        return jar.getFileName().toString();
    }

    private static long checksum(File jar) throws IOException {
        long sum = jar.length();
        try (ZipFile zip = new ZipFile(jar)) {
            for (Enumeration<? extends ZipEntry> entries = zip.entries(); entries.hasMoreElements(); ) {
                ZipEntry entry = entries.nextElement();
                sum = (sum ^ entry.getCrc() ^ entry.getName().hashCode()) * ODD;
                sum ^= sum >>> 29;
            }
        }
        return sum;
    }
}
