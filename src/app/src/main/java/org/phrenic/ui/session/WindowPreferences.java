package org.phrenic.ui.session;

import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.BiConsumer;
import java.util.function.BinaryOperator;
import java.util.logging.Level;
import java.util.logging.Logger;
import java.util.prefs.BackingStoreException;
import java.util.prefs.Preferences;

/** What the window remembers, in the platform's preferences. Headless runs do not use it. */
public final class WindowPreferences {
    /** System property that names another node of the preferences, for tests and second installations. */
    public static final String NODE_PROPERTY = "phrenic.preferences";

    private static final String DEFAULT_NODE = "org/phrenic/window";
    private static final int MAX_RECENT = 8;
    private static final String SEPARATOR = "\n";

    /** A strong reference: java.util.logging keeps loggers, and their levels, weakly. */
    private static final Logger PLATFORM = Logger.getLogger("java.util.prefs");

    /** What stands in where the platform stores nothing. */
    private static final WindowPreferences UNTIL_THE_END = unsaved();

    /** Whether the platform stores preferences is found out at the first use. */
    private static final class Platform {
        static final Optional<String> OBSTACLE = obstacle();

        /** Silences the platform where it stores nothing: it would warn of that every 30 s. */
        private static Optional<String> obstacle() {
            Level before = PLATFORM.getLevel();
            PLATFORM.setLevel(Level.OFF);
            Optional<String> problem = problem(Preferences.userRoot());
            problem.ifPresentOrElse(
                    sentence -> System.getLogger(WindowPreferences.class.getName())
                            .log(System.Logger.Level.WARNING, sentence),
                    () -> PLATFORM.setLevel(before));
            return problem;
        }
    }

    private final BinaryOperator<String> get;
    private final BiConsumer<String, String> put;

    /** Preferences kept under a node. */
    public WindowPreferences(Preferences node) {
        this(node::get, node::put);
    }

    WindowPreferences(BinaryOperator<String> get, BiConsumer<String, String> put) {
        this.get = get;
        this.put = put;
    }

    /**
     * Those of the user. Where the platform cannot store them, as in a home folder that cannot be written, they last
     * until the program ends.
     */
    public static WindowPreferences ofUser() {
        return obstacle().isPresent()
                ? UNTIL_THE_END
                : new WindowPreferences(Preferences.userRoot().node(System.getProperty(NODE_PROPERTY, DEFAULT_NODE)));
    }

    /** Why what the window remembers lasts until the program ends; empty if the platform stores it. */
    public static Optional<String> obstacle() {
        return Platform.OBSTACLE;
    }

    /** Why preferences cannot be stored; empty if they can. */
    static Optional<String> problem(Preferences node) {
        try {
            node.flush();
            return Optional.empty();
        } catch (BackingStoreException | SecurityException e) {
            return Optional.of("What the window remembers cannot be stored and lasts until it is closed ("
                    + String.valueOf(e.getMessage()).replaceFirst("\\.$", "") + ").");
        }
    }

    /** Preferences that are not saved. */
    public static WindowPreferences unsaved() {
        Map<String, String> values = new HashMap<>();
        return new WindowPreferences(values::getOrDefault, values::put);
    }

    public boolean isDark() {
        return flag("dark", false);
    }

    public void setDark(boolean dark) {
        setFlag("dark", dark);
    }

    public Workspace workspace() {
        String name = get.apply("arrangement", "");
        return name.equals(Workspace.CLINICIAN.name()) ? Workspace.CLINICIAN : Workspace.RESEARCHER;
    }

    public void setWorkspace(Workspace workspace) {
        put.accept("arrangement", workspace.name());
    }

    /** A number under a name; {@code otherwise} if there is none. */
    public int number(String name, int otherwise) {
        try {
            return Integer.parseInt(get.apply(name, String.valueOf(otherwise)));
        } catch (NumberFormatException e) {
            return otherwise;
        }
    }

    public void setNumber(String name, int value) {
        put.accept(name, String.valueOf(value));
    }

    /** A flag under a name; {@code otherwise} if there is none. */
    public boolean flag(String name, boolean otherwise) {
        return Boolean.parseBoolean(get.apply(name, String.valueOf(otherwise)));
    }

    public void setFlag(String name, boolean value) {
        put.accept(name, String.valueOf(value));
    }

    /** Files opened lately, the latest first. One on a drive that is away takes long to look for, so none is. */
    public List<Path> recent() {
        return Arrays.stream(get.apply("recent", "").split(SEPARATOR))
                .filter(text -> !text.isBlank())
                .flatMap(text -> path(text).stream())
                .toList();
    }

    /** Adds a file as the latest. */
    public void addRecent(Path file) {
        Path whole = file.toAbsolutePath().normalize();
        List<Path> list = new ArrayList<>(recent());
        list.remove(whole);
        list.add(0, whole);
        while (list.size() > 1 && (list.size() > MAX_RECENT || joined(list).length() > Preferences.MAX_VALUE_LENGTH)) {
            list.remove(list.size() - 1);
        }
        if (joined(list).length() <= Preferences.MAX_VALUE_LENGTH) {
            put.accept("recent", joined(list));
        }
    }

    /** A stored path; empty if its characters are none of this system's, as in a session with another encoding. */
    private static Optional<Path> path(String text) {
        try {
            return Optional.of(Path.of(text));
        } catch (InvalidPathException otherEncoding) {
            return Optional.empty();
        }
    }

    private static String joined(List<Path> paths) {
        return String.join(SEPARATOR, paths.stream().map(Path::toString).toList());
    }

    /** Folder of the file chosen last. */
    public Path folder() {
        return path(get.apply("folder", System.getProperty("user.home", ".")))
                .filter(Files::isDirectory)
                .orElseGet(() -> Path.of("").toAbsolutePath());
    }

    public void setFolder(Path folder) {
        put.accept("folder", folder.toString());
    }
}
