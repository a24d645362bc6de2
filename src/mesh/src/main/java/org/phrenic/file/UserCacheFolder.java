package org.phrenic.file;

import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Properties;

/** Where the cache of a user lies: the rules of {@link UserCache}, by system. */
final class UserCacheFolder {
    private static final String OFF = "off";

    private UserCacheFolder() {}

    /**
     * The folder of the cache; empty if it is switched off or the system names no folder for it.
     *
     * @param environment variables of the process
     * @param system properties of the Java machine: {@code os.name}, {@code user.home}
     */
    static Optional<Path> of(Map<String, String> environment, Properties system) {
        String stated = environment.getOrDefault(UserCache.VARIABLE, "");
        if (!stated.isEmpty()) {
            return OFF.equalsIgnoreCase(stated) ? Optional.empty() : path(stated);
        }
        String os = system.getProperty("os.name", "").toLowerCase(Locale.ROOT);
        Optional<Path> home = FileNames.absolutePath(system.getProperty("user.home"));
        if (os.startsWith("windows")) {
            return path(environment.getOrDefault("LOCALAPPDATA", ""))
                    .or(() -> home.map(folder -> folder.resolve("AppData").resolve("Local")))
                    .map(folder -> folder.resolve("Phrenic").resolve("cache"));
        }
        if (os.startsWith("mac")) {
            return home.map(
                    folder -> folder.resolve("Library").resolve("Caches").resolve("phrenic"));
        }
        // XDG Base Directory Specification: a relative path counts as absent.
        return FileNames.absolutePath(environment.get("XDG_CACHE_HOME"))
                .or(() -> home.map(folder -> folder.resolve(".cache")))
                .map(folder -> folder.resolve("phrenic"));
    }

    private static Optional<Path> path(String text) {
        try {
            return text.isEmpty() ? Optional.empty() : Optional.of(Path.of(text));
        } catch (InvalidPathException e) {
            return Optional.empty();
        }
    }
}
