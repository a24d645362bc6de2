package org.phrenic.ui.session;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.function.UnaryOperator;
import java.util.stream.Stream;
import org.phrenic.document.YamlWriter;
import org.phrenic.file.AtomicFile;
import org.phrenic.file.BadInputException;
import org.phrenic.file.FileNames;
import org.phrenic.scenario.Scenario;

/** Scenarios stored by name: files in one folder, which {@code phrenic run} takes as well. */
public record ScenarioStore(Path folder) {
    private static final String SUFFIX = ".yaml";
    private static final int MAX_NAME_LENGTH = 60;

    /**
     * The folder of the platform for an application's data.
     *
     * @param system name of the operating system
     * @param environment variables by name, null for one that is not set
     */
    static Path folderOf(String system, UnaryOperator<String> environment, Path home) {
        String name = system.toLowerCase(Locale.ROOT);
        if (name.contains("mac")) {
            return home.resolve("Library/Application Support/Phrenic/settings");
        }
        if (name.contains("win")) {
            String roaming = environment.apply("APPDATA");
            return (roaming == null ? home.resolve("AppData/Roaming") : Path.of(roaming)).resolve("Phrenic/settings");
        }
        // XDG Base Directory Specification: a relative path counts as absent.
        Path data = FileNames.absolutePath(environment.apply("XDG_DATA_HOME"))
                .orElseGet(() -> home.resolve(".local/share"));
        return data.resolve("phrenic/settings");
    }

    public static ScenarioStore ofUser() {
        return new ScenarioStore(folderOf(
                System.getProperty("os.name", ""), System::getenv, Path.of(System.getProperty("user.home", "."))));
    }

    /** The folder of the platform for the data of this application; the settings are in one of its folders. */
    public Path dataFolder() {
        return folder.toAbsolutePath().getParent();
    }

    /** Names of the stored scenarios, in alphabetical order. */
    public List<String> names() {
        if (!Files.isDirectory(folder)) {
            return List.of();
        }
        try (Stream<Path> files = Files.list(folder)) {
            return files.map(file -> file.getFileName().toString())
                    .filter(file -> file.endsWith(SUFFIX) && !file.startsWith("."))
                    .map(file -> file.substring(0, file.length() - SUFFIX.length()))
                    .sorted(String.CASE_INSENSITIVE_ORDER.thenComparing(name -> name))
                    .toList();
        } catch (IOException e) {
            throw new BadInputException(folder + ": cannot be listed: " + e.getMessage(), e);
        }
    }

    /** Whether a scenario of a name is stored; on systems that ignore case, whatever its case. */
    public boolean contains(String name) {
        return Files.exists(file(name));
    }

    /**
     * Stores a scenario under a name, and replaces one of that name.
     *
     * @throws BadInputException if no file can have that name
     * @throws org.phrenic.file.OutputException if it cannot be written
     */
    public void save(String name, Scenario scenario) {
        Map<String, Object> values = new LinkedHashMap<>(scenario.toMap());
        values.put("name", name);
        // Steps and changes belong to a run.
        values.remove("steps");
        values.remove("changes");
        YamlWriter.write(file(name), values);
    }

    /**
     * The scenario of a name.
     *
     * @throws BadInputException if there is none, or it is not valid
     */
    public Scenario load(String name) {
        return Scenario.read(file(name));
    }

    /** Deletes a scenario; does nothing if there is none. */
    public void delete(String name) {
        AtomicFile.delete(file(name));
    }

    private Path file(String name) {
        String plain = name.strip();
        boolean usable = plain.length() <= MAX_NAME_LENGTH && !plain.startsWith(".") && FileNames.isPortable(plain);
        if (!usable) {
            throw new BadInputException("name of settings: found '" + name + "', expected 1 to " + MAX_NAME_LENGTH
                    + " letters, digits, spaces, and no / \\ : * ? \" < > |, and no name of a device such as con");
        }
        return folder.resolve(plain + SUFFIX);
    }
}
