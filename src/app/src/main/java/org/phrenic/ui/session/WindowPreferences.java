package org.phrenic.ui.session;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.prefs.Preferences;

/**
 * What the window remembers from one time to the next, in the platform's preferences. Headless runs never come here.
 */
public final class WindowPreferences {
    /** System property that names another node, so that tests and second installations leave a user's own alone. */
    public static final String NODE_PROPERTY = "phrenic.preferences";

    private static final String DEFAULT_NODE = "org/phrenic/window";
    private static final int MAX_RECENT = 8;
    private static final String SEPARATOR = "\n";

    private final Preferences node;

    /** @param node under which everything is kept */
    public WindowPreferences(Preferences node) {
        this.node = node;
    }

    /** Those of this user. */
    public static WindowPreferences ofUser() {
        return new WindowPreferences(Preferences.userRoot().node(System.getProperty(NODE_PROPERTY, DEFAULT_NODE)));
    }

    /** Whether the window was dark. */
    public boolean isDark() {
        return node.getBoolean("dark", false);
    }

    public void setDark(boolean dark) {
        node.putBoolean("dark", dark);
    }

    /** The arrangement last chosen. */
    public Workspace workspace() {
        String name = node.get("arrangement", Workspace.RESEARCHER.name());
        return Arrays.stream(Workspace.values())
                .filter(a -> a.name().equals(name))
                .findFirst()
                .orElse(Workspace.RESEARCHER);
    }

    public void setWorkspace(Workspace arrangement) {
        node.put("arrangement", arrangement.name());
    }

    /** A number under a name, or {@code otherwise}. */
    public int number(String name, int otherwise) {
        return node.getInt(name, otherwise);
    }

    public void setNumber(String name, int value) {
        node.putInt(name, value);
    }

    /** A yes or no under a name, or {@code otherwise}. */
    public boolean flag(String name, boolean otherwise) {
        return node.getBoolean(name, otherwise);
    }

    public void setFlag(String name, boolean value) {
        node.putBoolean(name, value);
    }

    /** Files opened lately that still exist, the latest first. */
    public List<Path> recent() {
        return Arrays.stream(node.get("recent", "").split(SEPARATOR))
                .filter(text -> !text.isBlank())
                .map(Path::of)
                .filter(Files::exists)
                .toList();
    }

    /** Remembers a file as the latest. */
    public void addRecent(Path file) {
        Path whole = file.toAbsolutePath().normalize();
        List<Path> list = new ArrayList<>(recent());
        list.remove(whole);
        list.add(0, whole);
        while (list.size() > 1 && (list.size() > MAX_RECENT || joined(list).length() > Preferences.MAX_VALUE_LENGTH)) {
            list.remove(list.size() - 1);
        }
        if (joined(list).length() <= Preferences.MAX_VALUE_LENGTH) {
            node.put("recent", joined(list));
        }
    }

    private static String joined(List<Path> paths) {
        return String.join(SEPARATOR, paths.stream().map(Path::toString).toList());
    }

    /** Folder in which files were chosen last. */
    public Path folder() {
        Path folder = Path.of(node.get("folder", System.getProperty("user.home", ".")));
        return Files.isDirectory(folder) ? folder : Path.of("").toAbsolutePath();
    }

    public void setFolder(Path folder) {
        node.put("folder", folder.toString());
    }
}
