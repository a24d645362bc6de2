package org.phrenic.file;

import java.io.IOException;
import java.net.URISyntaxException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.security.CodeSource;
import java.util.Collection;
import java.util.LinkedHashSet;
import java.util.Optional;
import java.util.Set;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.zip.ZipEntry;
import java.util.zip.ZipFile;

/**
 * Tells builds of the program apart by the checksums of the classes and data that compute. Packed in several jars or
 * all in one, a build is the same.
 */
public final class ProgramBuild {
    private static final String PROGRAM = "org/phrenic/";
    private static final int DIGITS = 12;

    private ProgramBuild() {}

    /**
     * Version and build of the running program, such as {@code phrenic 0.1.0 build 0123456789ab}; without a build if it
     * does not run from jars, as in a development environment.
     *
     * @param others packages below {@code org.phrenic} that compute nothing of what the build is stated for, also those
     *     of jars that are not among the given ones: all jars may be packed in one
     * @param classes one of each jar that computes
     */
    public static String program(Set<String> others, Class<?>... classes) {
        String version = classes[0].getPackage().getImplementationVersion();
        return "phrenic " + (version == null ? "(not packaged)" : version)
                + of(others, classes).map(digits -> " build " + digits).orElse("");
    }

    /** The build of the running program as hexadecimal digits; empty if it does not run from jars. */
    static Optional<String> of(Set<String> others, Class<?>... classes) {
        Set<Path> jars = new LinkedHashSet<>();
        for (Class<?> each : classes) {
            CodeSource source = each.getProtectionDomain().getCodeSource();
            if (source == null) {
                return Optional.empty();
            }
            try {
                jars.add(Path.of(source.getLocation().toURI()));
            } catch (URISyntaxException | IllegalArgumentException noFile) {
                return Optional.empty();
            }
        }
        return ofJars(others, jars);
    }

    /** The build that jars contain; empty if one of them is none. */
    static Optional<String> ofJars(Set<String> others, Collection<Path> jars) {
        SortedMap<String, Long> checksums = new TreeMap<>();
        for (Path jar : jars) {
            try (ZipFile zip = new ZipFile(jar.toFile())) {
                zip.stream()
                        .filter(entry -> isComputing(others, entry))
                        .forEach(entry -> checksums.put(entry.getName(), entry.getCrc()));
            } catch (IOException none) {
                return Optional.empty();
            }
        }
        byte[] text = checksums.toString().getBytes(StandardCharsets.UTF_8);
        return checksums.isEmpty()
                ? Optional.empty()
                : Optional.of(Hashes.sha256(text).substring(0, DIGITS));
    }

    private static boolean isComputing(Set<String> others, ZipEntry entry) {
        String name = entry.getName();
        if (entry.isDirectory() || !name.startsWith(PROGRAM)) {
            return false;
        }
        String below = name.substring(PROGRAM.length());
        return !others.contains(below.substring(0, Math.max(0, below.indexOf('/'))));
    }
}
