module Dioptre.Files.FaultSpec (spec) where

import Control.Exception (ErrorCall (..), evaluate, throwIO)
import Control.Monad (forM_)
import qualified Data.Text as Text
import Dioptre.Files.Fault
import Foreign.C.Error
import System.IO (IOMode (ReadMode), openFile)
import System.IO.Error (mkIOError, userErrorType)
import System.IO.Temp (withSystemTempDirectory)
import Test.Hspec

spec :: Spec
spec = do
  describe "reasonOf" $ do
    let refusal number = errnoToIOError "write" number Nothing (Just "somewhere")
    forM_
      [ (eNOENT, DoesNotExist),
        (eACCES, PermissionDenied),
        (ePERM, PermissionDenied),
        (eROFS, PermissionDenied),
        (eISDIR, IsAFolder),
        (eNOTDIR, NotAFolder),
        (eNOSPC, DiskFull),
        (eDQUOT, DiskFull),
        (eFBIG, DiskFull),
        (eMFILE, TooManyOpen),
        (eNFILE, TooManyOpen),
        (eLOOP, LinksInACircle)
      ]
      $ \(number@(Errno value), reason) ->
        it ("reads error number " <> show value <> " as " <> show reason) $
          reasonOf (refusal number) `shouldBe` reason

    it "does not take other shortages for a full disk" $
      forM_ [eBUSY, eNOMEM] $ \number ->
        reasonOf (refusal number) `shouldSatisfy` isOther

    it "always has a text for what is not on the list" $
      reasonOf (mkIOError userErrorType "" Nothing Nothing) `shouldSatisfy` isOther

    it "knows the run-time system's own refusal to open a folder" $
      withSystemTempDirectory "fault" $ \folder -> do
        result <- orFault "scene" (openFile folder ReadMode)
        either Just (const Nothing) result `shouldBe` Just (FileFault "scene" IsAFolder)

  describe "orFault" $ do
    it "gives the result where there is no fault" $
      orFault "scene" (pure 'x') `shouldReturn` Right 'x'

    it "lets exceptions pass that are not about files" $ do
      orFault "scene" (throwIO (ErrorCall "picture") :: IO ()) `shouldThrow` errorCall "picture"
      orFault "scene" (evaluate (error "picture") :: IO ()) `shouldThrow` errorCall "picture"
  where
    isOther (OtherReason text) = not (Text.null text)
    isOther _ = False
