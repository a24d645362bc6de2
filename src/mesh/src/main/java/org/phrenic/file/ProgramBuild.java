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
    /** Packages that compute no result of a run, and that are not in all packages of the program. */
    private static final Set<String> OTHERS = Set.of("cli", "cluster", "fit", "scene", "ui");

    private static final int DIGITS = 12;

    private ProgramBuild() {}

    /**
     * The build of the running program as hexadecimal digits; empty if it does not run from jars, as in a development
     * environment.
     *
     * @param classes one of each jar that computes
     */
    public static Optional<String> of(Class<?>... classes) {
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
        return ofJars(jars);
    }

    /** The build that jars contain; empty if one of them is none. */
    static Optional<String> ofJars(Collection<Path> jars) {
        SortedMap<String, Long> checksums = new TreeMap<>();
        for (Path jar : jars) {
            try (ZipFile zip = new ZipFile(jar.toFile())) {
                zip.stream()
                        .filter(ProgramBuild::isComputing)
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

    private static boolean isComputing(ZipEntry entry) {
        String name = entry.getName();
        if (entry.isDirectory() || !name.startsWith(PROGRAM)) {
            return false;
        }
        String below = name.substring(PROGRAM.length());
        return !OTHERS.contains(below.substring(0, Math.max(0, below.indexOf('/'))));
    }
}
