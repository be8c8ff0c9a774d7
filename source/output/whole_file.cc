#include <signorini/output/whole_file.h>

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>

namespace Signorini
{
  namespace
  {
    // Closes the file in any case, and for good.
    class Descriptor
    {
    public:
      explicit Descriptor(const std::string &path)
        : number_(::open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0666))
      {
        require(number_ >= 0);
      }

      ~Descriptor()
      {
        if (number_ >= 0)
          ::close(number_);
      }

      Descriptor(const Descriptor &) = delete;
      Descriptor &
      operator=(const Descriptor &) = delete;

      void
      write(const std::string &content) const
      {
        std::size_t n_written = 0;
        while (n_written < content.size())
          {
            const ssize_t n = ::write(number_,
                                      content.data() + n_written,
                                      content.size() - n_written);
            if (n < 0 && errno == EINTR)
              continue;
            require(n > 0);
            n_written += n;
          }
        // Pipes and devices cannot be synchronised, and need not be.
        require(::fsync(number_) == 0 || errno == EINVAL);
      }

      void
      close()
      {
        const int number = number_;
        number_          = -1;
        require(::close(number) == 0);
      }

    private:
      static void
      require(const bool success)
      {
        if (!success)
          throw std::system_error(errno, std::generic_category());
      }

      int number_;
    };
  } // namespace



  void
  write_to_disk(const std::string &path, const std::string &content)
  {
    Descriptor file(path);
    file.write(content);
    file.close();
  }
} // namespace Signorini
