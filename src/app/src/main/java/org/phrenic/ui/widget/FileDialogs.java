package org.phrenic.ui.widget;

import java.awt.Component;
import java.io.File;
import java.nio.file.Path;
import java.util.Locale;
import java.util.Optional;
import javax.swing.JFileChooser;
import javax.swing.JOptionPane;
import javax.swing.filechooser.FileNameExtensionFilter;
import org.phrenic.ui.session.WindowPreferences;

/** Asks for files to write or read; remembers the folder. */
public final class FileDialogs {
    private FileDialogs() {}

    /** Asks where to write; the suffix of {@code proposed} is added where it is missing. Empty if it was called off. */
    public static Optional<Path> save(Component parent, String title, String proposed) {
        String suffix = proposed.substring(proposed.lastIndexOf('.') + 1);
        JFileChooser chooser = fileChooser(title, suffix);
        chooser.setSelectedFile(new File(chooser.getCurrentDirectory(), proposed));
        if (chooser.showSaveDialog(parent) != JFileChooser.APPROVE_OPTION) {
            return Optional.empty();
        }
        File chosen = chooser.getSelectedFile();
        File file = chosen.getName().toLowerCase(Locale.ROOT).endsWith("." + suffix)
                ? chosen
                : new File(chosen.getParentFile(), chosen.getName() + "." + suffix);
        rememberFolder(file);
        boolean write = !file.exists()
                || JOptionPane.showConfirmDialog(
                                parent,
                                "Replace " + file.getName() + ", which is there already?",
                                title,
                                JOptionPane.OK_CANCEL_OPTION)
                        == JOptionPane.OK_OPTION;
        return write ? Optional.of(file.toPath()) : Optional.empty();
    }

    /** Asks which file to read; empty if it was called off. */
    public static Optional<Path> open(Component parent, String title, String... suffixes) {
        JFileChooser chooser = fileChooser(title, suffixes);
        if (chooser.showOpenDialog(parent) != JFileChooser.APPROVE_OPTION) {
            return Optional.empty();
        }
        rememberFolder(chooser.getSelectedFile());
        return Optional.of(chooser.getSelectedFile().toPath());
    }

    /** Asks for a folder to write into, one that is there or a new one; empty if it was called off. */
    public static Optional<Path> folder(Component parent, String title) {
        JFileChooser chooser =
                new JFileChooser(WindowPreferences.ofUser().folder().toFile());
        chooser.setDialogTitle(title);
        chooser.setFileSelectionMode(JFileChooser.DIRECTORIES_ONLY);
        if (chooser.showSaveDialog(parent) != JFileChooser.APPROVE_OPTION) {
            return Optional.empty();
        }
        File chosen = chooser.getSelectedFile();
        rememberFolder(chosen);
        boolean write = !new File(chosen, "report.json").exists()
                || JOptionPane.showConfirmDialog(
                                parent,
                                "Replace the report in " + chosen.getName() + "?",
                                title,
                                JOptionPane.OK_CANCEL_OPTION)
                        == JOptionPane.OK_OPTION;
        return write ? Optional.of(chosen.toPath()) : Optional.empty();
    }

    private static JFileChooser fileChooser(String title, String... suffixes) {
        JFileChooser chooser =
                new JFileChooser(WindowPreferences.ofUser().folder().toFile());
        chooser.setDialogTitle(title);
        chooser.setFileFilter(
                new FileNameExtensionFilter(String.join(", ", suffixes).toUpperCase(Locale.ROOT) + " files", suffixes));
        return chooser;
    }

    private static void rememberFolder(File file) {
        WindowPreferences.ofUser()
                .setFolder(file.getAbsoluteFile().getParentFile().toPath());
    }
}
