package wbv.fleet;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import wbv.recording.DataFault;
import wbv.seat.Packet;

/** The packets of files. */
final class FileFeed implements Feed {

    private final PacketFiles files;
    private final String text;
    private final long[] before;

    FileFeed(List<Path> files, Place from) throws IOException {
        this.files = new PacketFiles(files, from.part(), from.at(), from.count());
        this.text = PacketFiles.text(files);
        this.before = new long[files.size() + 1];
        for (int k = 0; k < files.size(); k++) {
            before[k + 1] = before[k] + Files.size(files.get(k));
        }
    }

    @Override
    public String text() {
        return text;
    }

    @Override
    public Optional<Sent> next() throws IOException {
        return files.next().map(FileFeed::sent);
    }

    private static Sent sent(byte[] bytes) {
        try {
            return new Read(Packet.of(bytes));
        } catch (DataFault unread) {
            return new Unread(bytes, unread.getMessage());
        }
    }

    @Override
    public Place place() {
        return new Place(files.count(), files.part(), files.at(), 0);
    }

    @Override
    public double share() {
        long all = before[before.length - 1];
        return all == 0 ? 1 : (double) (before[files.part()] + files.at()) / all;
    }

    @Override
    public void close() throws IOException {
        files.close();
    }
}
